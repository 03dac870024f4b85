% CHECKMATRICES  Names what is wrong with the matrices of a diagnosis.
%
% CALL: DATA = checkMatrices (GIVEN, DATA, EVALUATE)
%
%   GIVEN, DATA, EVALUATE  see diagnoseMatrices
%   DATA  with E neutral and replicate 1 where they were not given
%
% A misspelt field would be taken for one that is not there, and runs in another
% unit than the limits would all count as runs far away, or all as one place. Without a
% single result for a measured value nothing can be said of it.
%
% Errors: DEcalioc:checkMatrices:unknownField, :missingField, :otherUnits, :badValue (limits
% that are not 2 x p with the lower ones first, bench that is no number, a value that no run
% has a result for)

function data = checkMatrices (given, data, evaluate)
  % the last ones: of a problem of newProblem, of diagnoseCase
  known = [{'limits', 'allowed', 'covariance', 'effects', 'causes', 'reference', ...
            'form'}, {problemFields().name}, ...
           {'tests', 'options', 'prior', 'shape', 'cost', 'standard', 'nExtra', 'coarse', ...
            'fine', 'used', 'heldOut', 'possible', 'statedSd', 'kept', 'unit', ...
            'centre', 'paramPrior', 'out', 'neverRun', 'lacking', 'odd'}];
  refuseUnknown ('GIVEN', given, known, 1:7 + numel (problemFields ()));
  refuseUnknown ('DATA', data, {'X', 'E', 'Z', 'replicate', 'level', 'stage'}, 1:5);
  refuseMissing ('GIVEN', given, {'value', 'sd', 'limits', 'bench'});
  refuseMissing ('DATA', data, {'X', 'Z'});
  refuseLimits (given);
  n = rows (data.X);
  if ~isfield (data, 'E')
    data.E = repmat (neutralOf (givenField (given, 'effects', [])), n, 1);
  end
  if ~isfield (data, 'replicate')
    data.replicate = ones (n, 1);
  end
  isThere = isnumeric (data.X) && columns (data.X) == columns (given.limits);
  if isempty (evaluate) && isThere && n > 0
    checkUnits (given, data.X);
    if ~isfield (data, 'stage')                  % else of a case, whose limits may change
      checkStrengths (given, data.E);
      checkPercent (given, data.X);
      checkResults (given, data.Z);
    end
  end
end

function refuseLimits (given)
  limits = given.limits;
  if ~isnumeric (limits) || rows (limits) < 2 || any (limits(1, :) > limits(2, :))
    error ('DEcalioc:checkMatrices:badValue', ...
           ['diagnoseMatrices: GIVEN.limits must have the lower limits in its first row, the ' ...
            'upper ones in its second, a column a parameter, got %s.'], describeValue (limits));
  elseif ~isnumeric (given.bench) || ~all (ismember (given.bench(:), 1:numel (given.bench)))
    error ('DEcalioc:checkMatrices:badValue', ...
           ['diagnoseMatrices: GIVEN.bench must number the bench of each value, from 1 on, ' ...
            'got %s.'], describeValue (given.bench));
  end
end

function refuseUnknown (what, value, known, shown)
  if ~isstruct (value)
    error ('DEcalioc:checkMatrices:badValue', 'diagnoseMatrices: %s must be a struct, got %s.', ...
           what, describeValue (value));
  end
  unknown = setdiff (fieldnames (value)', known);
  if ~isempty (unknown)
    error ('DEcalioc:checkMatrices:unknownField', ...
           'diagnoseMatrices: %s must have known fields, got %s. %s It may have: %s.', ...
           what, strjoin (unknown, ', '), checkNearest (unknown{1}, known), ...
           strjoin (known(shown), ', '));
  end
end

function refuseMissing (what, value, needed)
  missing = needed(~isfield (value, needed));
  if ~isempty (missing)
    error ('DEcalioc:checkMatrices:missingField', ...
           'diagnoseMatrices: %s must have the fields %s; missing: %s.', what, ...
           strjoin (needed, ', '), strjoin (missing, ', '));
  end
end

function neutral = neutralOf (effects)
  neutral = zeros (1, 0);
  for effect = reshape (effects, 1, [])
    if ~isequal (givenField (effect, 'laboratory', false), true)
      neutral = [neutral, reshape(givenField (effect, 'neutral', []), 1, [])];
    end
  end
end

% Runs beyond the limits tell of what is within; where none is, nothing does.
function checkUnits (given, X)
  [~, isIn] = insideLimits (X, given.limits);
  if any (isIn)
    return
  end
  ends = [min(X, [], 1); max(X, [], 1)];
  isOut = ends(1, :) > given.limits(2, :) | ends(2, :) < given.limits(1, :);
  names = arrayfun (@(k) sprintf ('p%d', k), 1:columns (X), 'UniformOutput', false);
  names = givenField (given, 'names', names);
  said = 'for each parameter';
  if any (isOut)
    parts = arrayfun (@(k) sprintf ('%s: %g to %g, limits %g to %g', names{k}, ...
                                    ends(:, k), given.limits(1:2, k)), ...
                      find (isOut), 'UniformOutput', false);
    said = strjoin (parts, '; ');
  end
  error ('DEcalioc:checkMatrices:otherUnits', ...
         ['diagnoseMatrices: a run of DATA.X must lie between GIVEN.limits, got none ' ...
          'of %d (%s). Give both in one unit, or widen the limits.'], rows (X), said);
end

% A column that fills its limits once it is multiplied or divided by 100 or 1000, and lies
% at one of their ends, or mostly outside, as it is.
function checkPercent (given, X)
  low = given.limits(1, :);
  width = given.limits(2, :) - low;
  place = @(X) (X - low) ./ width;
  isIn = @(U) mean (U >= 0 & U <= 1, 1);
  spread = @(U) max (U, [], 1) - min (U, [], 1);
  U = place (X);
  isLinear = ~any (given.limits(3:end, :), 1);
  for f = [100, 1000]
    for factor = [f, 1 / f]
      V = place (X * factor);
      k = find (isLinear & isIn (V) >= 0.9 & spread (V) > 0.3 & ...
                (isIn (U) < 0.5 | spread (U) < 0.03), 1);
      if ~isempty (k)
        error ('DEcalioc:checkMatrices:otherUnits', ...
               ['diagnoseMatrices: column %d of DATA.X must have the unit of GIVEN.limits, ' ...
                'got %g to %g, limits %g to %g; times %g it would fill them. Give both in ' ...
                'one unit, or the limits that the runs have.'], k, min (X(:, k)), ...
               max (X(:, k)), given.limits(1:2, k), factor);
      end
    end
  end
end

% A bench of which all runs failed is left out (enterRuns); one result alone is a slip.
function checkResults (given, Z)
  if ~isnumeric (Z) || columns (Z) ~= numel (given.value)
    return                               % said elsewhere
  end
  isNone = ~any (isfinite (Z), 1);
  ran = ismember (given.bench(:)', given.bench(~isNone));
  none = find (isNone & ran & isfinite (given.value(:)'), 1);
  if ~isempty (none)
    error ('DEcalioc:checkMatrices:badValue', ...
           ['diagnoseMatrices: column %d of DATA.Z must have a result of some run for the ' ...
            'measured value %g, got none that is finite. Give NaN as its value, or take it ' ...
            'out.'], none, given.value(none));
  end
end

% Of runs with an effect, one has to lie between its limits, and one a hundredth of them
% away from neutral.
function checkStrengths (given, E)
  for k = 1:numel (givenField (given, 'effects', []))
    effect = given.effects(k);
    v = numel (givenField (effect, 'neutral', []));
    isRun = ~isequal (givenField (effect, 'laboratory', false), true);
    own = E(:, 1:min (v * isRun, end));
    E(:, 1:columns (own)) = [];
    limits = givenField (effect, 'limits', []);
    if columns (own) < v || ~isequal (size (limits), [2, v])
      continue
    end
    off = abs (own - effect.neutral);
    isOn = any (off > 0, 2);
    isIn = all (own >= min (limits, [], 1) & own <= max (limits, [], 1), 2);
    isFelt = any (off > 0.01 * max (abs (limits - effect.neutral), [], 1), 2);
    if any (isOn) && ~any (isIn & isOn & isFelt)
      error ('DEcalioc:checkMatrices:otherUnits', ...
             ['diagnoseMatrices: runs with the effect %s must reach from neutral into its ' ...
              'limits, got DATA.E from %g to %g, limits %g to %g. Give both in one unit.'], ...
             effect.name, min (own(:)), max (own(:)), limits(1), limits(2));
    end
  end
end

%!shared given, data
%! given = struct ('value', [1, 2], 'sd', [1, 1], 'limits', [0; 1], 'bench', [1, 1]);
%! given.effects = struct ('name', {'c', 'g'}, 'variables', {{'w'}, {}}, ...
%!                         'neutral', {3, 0}, 'laboratory', {[], true});
%! data = struct ('X', [0.2; 0.6; 1.4], 'Z', ones (3, 2));
%!test
%! d = checkMatrices (given, data, []);
%! % an effect without neutral is said by newEffect
%! checkMatrices (setfield (given, 'effects', rmfield (given.effects(1), 'neutral')), d, []);
%! assert ({d.E, d.replicate}, {[3; 3; 3], [1; 1; 1]});
%! % what a problem and the runs of a case have is known
%! checkMatrices (newProblem (rmfield (given, 'effects')), setfield (d, 'stage', {}), []);
%!error <got roles. .* It may have: limits, allowed, .*held>
%! checkMatrices (setfield (given, 'roles', {}), data, [])
%!error <got helt. Did you mean held> checkMatrices (setfield (given, 'helt', 1), data, [])
%!error <DATA must have known fields, got replicates. Did you mean replicate>
%! checkMatrices (given, setfield (data, 'replicates', 1), [])
%!error <missing: Z> checkMatrices (given, rmfield (data, 'Z'), [])
%!error <missing: sd, bench> checkMatrices (rmfield (given, {'sd', 'bench'}), data, [])
%!error <none of 3 .p1: 20 to 140, limits 0 to 1>
%! checkMatrices (given, setfield (data, 'X', 100 * data.X), [])
%!error <limits must have the lower limits in its first row>
%! checkMatrices (setfield (given, 'limits', [1; 0]), data, [])
%!error <bench must number the bench of each value, from 1 on>
%! checkMatrices (setfield (given, 'bench', [0, 1]), data, [])
%!error <GIVEN must be a struct> checkMatrices ({given}, data, [])
%!error <bench must number the bench>
%! checkMatrices (setfield (given, 'bench', {'a', 'b'}), data, [])
%!test
%! % strengths in other units
%! one = given;
%! one.effects(1).limits = [3; 43];
%! of = @(E) setfield (data, 'E', E);
%! checkMatrices (one, of ([3; 3; 20]), []);
%! checkMatrices (one, of ([3; 3; 3]), []);
%! fail ('checkMatrices (one, of ([3; 3; 3.02]), [])', 'effect c must reach .* 3 to 3.02');
%! fail ('checkMatrices (one, of ([3; 3; 20000]), [])', 'limits 3 to 43');
%!test
%! % runs may still be made
%! checkMatrices (given, setfield (data, 'X', 100 * data.X), @(varargin) 1);

% SPDX-License-Identifier: GPL-3.0-only
