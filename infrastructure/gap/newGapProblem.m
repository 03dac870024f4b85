% NEWGAPPROBLEM  Fills and checks the description of a diagnosis on matrices.
%
% CALL: PROBLEM = newGapProblem (GIVEN)
%
%   GIVEN    struct; required fields
%     y        1 x T, measured values; NaN = simulated but not (yet) measured
%     sd       1 x T, standard uncertainty of y
%     limits   2 x p, box of the calibrated parameters
%     bench    1 x T, number of the bench that each target belongs to
%   optional fields (default)
%     targetNames (t1 ...), benchNames (bench1 ...), names (p1 ...) cellstr
%     held        1 x T logical, kept out of every fit (none)
%     series      1 x T, targets with one number > 0 are the same quantity along
%                 a coordinate (0)
%     coordinate  1 x T, its value: speed, time, opening ... (0)
%     covariance  T x T of the measurement, instead of sd ([])
%     trials      how many trials y is the mean of: the real material has a
%                 packing of its own too, Inf if sd holds that scatter (1)
%     seedSd      1 x T, known scatter of one run over seeds (NaN: from data)
%     paramMean, paramSd   1 x p, values measured independently (NaN: none)
%     benchCost   1 x B, cost of one run of each bench (1)
%     effects     1 x K struct, see newEffect ([])
%   PROBLEM  the same with every field present, rows as rows
%
% Errors: DEcalioc:newGapProblem:missingField, :badShape, :badValue
%
% See also: diagnoseMatrices, newEffect

function problem = newGapProblem (given)
  needed = {'y', 'sd', 'limits', 'bench'};
  for k = 1:numel (needed)
    if ~isfield (given, needed{k})
      error ('DEcalioc:newGapProblem:missingField', ...
             'newGapProblem: GIVEN must have the field %s.', needed{k});
    end
  end
  T = numel (given.y);
  p = columns (given.limits);
  problem = withDefaults (given, T, p);
  problem.effects = arrayfun (@(e) newEffect (e, T), problem.effects(:)');
  checkShapes (problem, T, p);
  problem.used = find (isfinite (problem.y) & ~problem.held);
  problem.heldOut = find (isfinite (problem.y) & problem.held);
  problem.possible = find (~isfinite (problem.y));
  if isempty (problem.used)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: Y must hold at least one measured value that ' ...
            'is not held out, got none.']);
  end
end

function problem = withDefaults (given, T, p)
  B = max (given.bench);
  numbered = @(word, n) arrayfun (@(k) sprintf ('%s%d', word, k), 1:n, ...
                                  'UniformOutput', false);
  problem = struct ('held', false (1, T), 'series', zeros (1, T), ...
                    'coordinate', zeros (1, T), 'covariance', [], ...
                    'trials', 1, 'seedSd', NaN (1, T), ...
                    'paramMean', NaN (1, p), 'paramSd', NaN (1, p), ...
                    'benchCost', ones (1, B), 'effects', []);
  problem.targetNames = numbered ('t', T);
  problem.benchNames = numbered ('bench', B);
  problem.names = numbered ('p', p);
  fields = fieldnames (given);
  for k = 1:numel (fields)
    value = given.(fields{k});
    if isvector (value) && ~isstruct (value)
      value = reshape (value, 1, []);
    end
    problem.(fields{k}) = value;
  end
  problem.limits = reshape (problem.limits, 2, p);
  problem.held = logical (problem.held);
end

function checkShapes (problem, T, p)
  wide = {'y', 'sd', 'bench', 'held', 'series', 'coordinate', ...
          'seedSd', 'targetNames'};
  for k = 1:numel (wide)
    if numel (problem.(wide{k})) ~= T
      error ('DEcalioc:newGapProblem:badShape', ...
             'newGapProblem: %s must be 1 x %d like Y, got %d values.', ...
             wide{k}, T, numel (problem.(wide{k})));
    end
  end
  if numel (problem.names) ~= p || ~all (diff (problem.limits) > 0)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: LIMITS must be 2 x %d with the lower limit ' ...
            'first in every column.'], numel (problem.names));
  end
  if ~all (problem.sd(isfinite (problem.y)) >= 0)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: SD must be >= 0 for every measured target. ' ...
            'Give the standard uncertainty of each measurement.']);
  end
end

%!test
%! given = struct ('y', [1, 2, NaN], 'sd', [1, 1, 1], 'limits', [0; 1], ...
%!                 'bench', [1, 1, 2]);
%! problem = newGapProblem (given);
%! assert (problem.used, [1, 2]);
%! assert (problem.possible, 3);
%! assert (problem.benchNames, {'bench1', 'bench2'});
%! given.held = [false, true, false];
%! problem = newGapProblem (given);
%! assert (problem.used, 1);
%! assert (problem.heldOut, 2);
%!error id=DEcalioc:newGapProblem:missingField newGapProblem (struct ('y', 1))
%!error id=DEcalioc:newGapProblem:badShape
%! newGapProblem (struct ('y', [1, 2], 'sd', 1, 'limits', [0; 1], ...
%!                        'bench', [1, 1]));
%!error id=DEcalioc:newGapProblem:badValue
%! newGapProblem (struct ('y', 1, 'sd', 1, 'limits', [1; 0], 'bench', 1));
