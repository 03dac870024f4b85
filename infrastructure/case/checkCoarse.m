% CHECKCOARSE  Checks the levels of Input.coarse, as far as they stand alone.
%
% CALL: P = checkCoarse (INPUT, N)
%
%   INPUT  scalar struct, the Input of loadInput
%   N      number of models
%   P      1 x n faults, see checkFault
%
% Input.coarse{k}: [] or a struct with the fields variable (a name) and levels
% (two and more different numbers, rising or falling; the last one counts). All
% models that have levels have as many.
%
% Reasons: badCoarse coarseCount badLevels levelCount
%
% See also: newCoarse, checkLevels

function p = checkCoarse (Input, n)
  p = checkFault ();
  if ~isfield (Input, 'coarse') || checkIs ('nothing', Input.coarse)
    return
  end
  cure = ['Write Input.coarse{1} = struct (''variable'', ''scaleP'', ' ...
          '''levels'', [1.6, 1.25, 1]); or leave it out.'];
  if ~iscell (Input.coarse)
    p = checkFault ('badCoarse', 'Input.coarse', ...
                    'a cell, one element a model', ...
                    checkShow (Input.coarse), cure);
    return
  end
  if n > 0 && numel (Input.coarse) > n
    p = checkFault ('coarseCount', 'Input.coarse', ...
                    sprintf ('at most %d element(s), one a model', n), ...
                    sprintf ('%d elements', numel (Input.coarse)), cure);
  end
  counts = zeros (1, 0);
  for k = find (~cellfun (@(c) checkIs ('nothing', c), Input.coarse(:)'))
    [q, counts(end + 1)] = checkOne (Input.coarse{k}, k, cure);
    p = [p, q];
  end
  if isempty (p) && any (counts ~= counts(1:min (1, end)))
    p = checkFault ('levelCount', 'Input.coarse', ...
                    'as many levels for each model that has some', ...
                    checkShow (counts), ...
                    'Give each model the same number of levels.');
  end
end

function [p, n] = checkOne (own, k, cure)
  p = checkFault ();
  n = 0;
  field = sprintf ('Input.coarse{%d}', k);
  if ~checkIs ('struct', own) || ~isfield (own, 'variable') || ...
     ~checkIs ('name', own.variable) || ~isfield (own, 'levels')
    p = checkFault ('badCoarse', field, ...
                    'a struct with the fields variable and levels', ...
                    checkShow (own), cure);
    return
  end
  p = checkFields (own, field, {'variable', 'levels'});
  levels = own.levels;
  isGood = checkIs ('vector', levels) && numel (levels) > 1 && ...
           all (isfinite (levels));
  isGood = isGood && (all (diff (levels) > 0) || all (diff (levels) < 0));
  if ~isGood
    p = [p, checkFault('badLevels', [field, '.levels'], ...
                       'two and more numbers, rising or falling', ...
                       checkShow (levels), ...
                       ['Put the coarsest and cheapest first, the one that ' ...
                        'counts last.'])];
    return
  end
  n = numel (levels);
end

%!function id = firstOf (coarse, n)
%!  p = checkCoarse (struct ('coarse', {coarse}), n);
%!  id = '-';
%!  if ~isempty (p)
%!    id = p(1).id;
%!  end
%!endfunction
%!test
%! good = struct ('variable', 'scaleP', 'levels', [2, 1]);
%! assert (firstOf ({good}, 1), '-');
%! assert (firstOf ({[], good}, 2), '-');
%! assert (firstOf (good, 1), 'DEcalioc:checkCase:badCoarse');
%! assert (firstOf ({good, good}, 1), 'DEcalioc:checkCase:coarseCount');
%! assert (firstOf ({3}, 1), 'DEcalioc:checkCase:badCoarse');
%! more = setfield (good, 'levels', [3, 2, 1]);
%! assert (firstOf ({good, more}, 2), 'DEcalioc:checkCase:levelCount');
%! for levels = {1, [1, 2, 1], [1, NaN], 'a', [1, 1]}
%!   bad = setfield (good, 'levels', levels{1});
%!   assert (firstOf ({bad}, 1), 'DEcalioc:checkCase:badLevels');
%! end
%! assert (isempty (checkCoarse (struct (), 1)));
