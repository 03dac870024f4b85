% NEWEVALUATE  Makes the function that the calibration calls for DEM results.
%
% CALL: EVALUATE = newEvaluate (CASE, LEDGER, SAY)
%
%   CASE      see newCase
%   LEDGER    see newLedger
%   SAY       function handle that takes one line of text
%   EVALUATE  Z = EVALUATE (P, REPLICATE), or with two arguments more, STAGE and
%             E: P n x d, REPLICATE n x 1, Z n x T, NaN where a run failed, NA
%             (isna) where a run of the set was not made because
%             Input.maxNewRuns is reached
%
% Where a model folder does not exist (a case of imported runs alone) nothing
% can be run: all is NA.
%
% See also: evaluateDEM, calibrateOnDEM

function evaluate = newEvaluate (Case, ledger, say)
  ledger('models') = Case.models;
  book = struct ('Case', Case, 'ledger', ledger, 'say', say);
  evaluate = @(P, replicate, varargin) ...
    bookedRuns (P, replicate, book, varargin{:});
end

function Z = bookedRuns (P, replicate, book, stage, E)
  Case = book.Case;
  ledger = book.ledger;
  if nargin < 4
    stage = 'calibration';
  end
  if nargin < 5
    E = [];
  end
  if any (cellfun (@isempty, {Case.models.folder}))
    Z = NA (rows (P), numel (Case.targets));
    return
  end
  Case.options.maxNewRuns = Case.options.maxNewRuns - ledger('new');
  Case.models = ledger('models');
  [Z, records, isReused, nNew] = evaluateDEM (P, Case, replicate, stage, ...
                                              newProgress (stage, book.say), E);
  isLeftOut = strcmp ({records.cause}, 'budget');
  Z(isnan (Z) & any (reshape (isLeftOut, size (records)), 2)) = NA;
  failed = ~strcmp ({records.status}, 'ok') & ~isLeftOut;
  ledger('models') = addSeconds (Case.models, records(:)');
  ledger('isUsedUp') = ledger('isUsedUp') || any (isLeftOut);
  ledger('new') = ledger('new') + nNew;
  ledger('reused') = ledger('reused') + sum (isReused(:));
  ledger('failed') = ledger('failed') + sum (failed);
  seconds = reshape ([records.seconds], size (records)) .* [Case.models.cpu];
  ledger('coreSeconds') = ledger('coreSeconds') + ...
                          sum (seconds(isfinite (seconds)));
  v = numel (Case.coarse);
  if v > 0 && columns (E) == v && isequal (Case.effectVars, ...
                                           {Case.coarse.variable})
    whole = all (strcmp (reshape ({records.status}, size (records)), 'ok'), 2);
    ledger('levels') = [ledger('levels'); ...
                        E(whole, 1:v), sum(seconds(whole, :), 2)];
  end
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! ledger = newLedger ();
%! Case.options.maxNewRuns = 5;
%! evaluate = newEvaluate (Case, ledger, @(text) []);
%! Z = evaluate ([1, 2; 3, 4], 1);
%! assert (ledger('new'), 4);
%! assert (ledger('isUsedUp'), false);
%! Z = evaluate ([1, 2; 5, 6; 7, 8], 1);
%! assert (ledger('isUsedUp'), true);
%! assert (ledger('reused'), 2);
%! assert (ledger('new'), 5);
%! assert (Z, [3, 2, -1; 11, 30, NA; NA, NA, NA], 1e-12);
%! assert (numel (listRunFolders (Case.store, 'First')), 3);
%!test
%! % one of two runs is not in the budget: the set was not tried
%! Case = newCase (standInCase (tempname ()));
%! Case.options.maxNewRuns = 3;
%! evaluate = newEvaluate (Case, newLedger (), @(text) []);
%! Z = evaluate ([1, 2; 3, 4], 1);
%! assert (any (isna (Z), 2), [false; true]);
%!test
%! % runs of later calls have the limit that the earlier ones gave
%! Case = newCase (standInCase (tempname ()));
%! evaluate = newEvaluate (Case, newLedger (), @(text) []);
%! evaluate ([1, 2; 3, 4; 5, 6], 1);
%! evaluate ([7, 8], 1);
%! runs = listRunFolders (Case.store, 'First');
%! limit = @(name) isfile (fullfile (Case.store, 'optim', 'First', name, ...
%!                                   'limit'));
%! assert (limit (runs{4}));
