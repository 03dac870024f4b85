% NEWEVALUATE  Makes the function that the calibration calls for DEM results.
%
% CALL: EVALUATE = newEvaluate (CASE, LEDGER, SAY)
%
%   CASE      see newCase
%   LEDGER    see newLedger
%   SAY       function handle that takes one line of text
%   EVALUATE  Z = EVALUATE (P, REPLICATE) or EVALUATE (P, REPLICATE, STAGE, E):
%             P n x d, REPLICATE n x 1, Z n x T, NaN where a run failed
%
% Where a model folder does not exist (a case of imported runs alone) nothing
% can be run and all is NaN.
%
% See also: evaluateDEM, calibrateOnDEM

function evaluate = newEvaluate (Case, ledger, say)
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
    Z = NaN (rows (P), numel (Case.targets));
    return
  end
  % what is left of the budget of new runs
  Case.options.maxNewRuns = Case.options.maxNewRuns - ledger('new');
  [Z, records, isReused] = evaluateDEM (P, Case, replicate, stage, ...
                                        newProgress (stage, book.say), E);
  wasRun = ~strcmp ({records.cause}, 'budget') & ~isReused(:)';
  failed = ~strcmp ({records.status}, 'ok') & ...
           ~strcmp ({records.cause}, 'budget');
  cpus = arrayfun (@(r) Case.models(strcmp (r.model, ...
                                            {Case.models.name})).cpu, ...
                   records(:)');
  seconds = [records.seconds];
  seconds(isnan (seconds)) = 0;
  ledger('new') = ledger('new') + sum (wasRun);
  ledger('reused') = ledger('reused') + sum (isReused(:));
  ledger('failed') = ledger('failed') + sum (failed);
  ledger('coreSeconds') = ledger('coreSeconds') + sum (seconds .* cpus);
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! ledger = newLedger ();
%! Case.options.maxNewRuns = 5;
%! evaluate = newEvaluate (Case, ledger, @(text) []);
%! Z = evaluate ([1, 2; 3, 4], 1);
%! assert (ledger('new'), 4);
%! Z = evaluate ([1, 2; 5, 6; 7, 8], 1);
%! assert (ledger('reused'), 2);
%! assert (ledger('new'), 5);
%! assert (Z, [3, 2, -1; 11, 30, NaN; NaN, NaN, NaN], 1e-12);
%! assert (numel (listRunFolders (Case.store, 'First')), 3);
