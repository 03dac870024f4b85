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
%     sdKnown     1 x T logical, false: sd is a first guess of a noise of
%                 unknown size (true)
%     held        1 x T logical, kept out of every fit (none)
%     series      1 x T, targets with one number > 0 are the same quantity along
%                 a coordinate (0)
%     coordinate  1 x T, its value: speed, time, opening ... (0)
%     covariance  T x T of the measurement, instead of sd ([])
%     estimateSeries  1 x T logical, the length over which the errors of its
%                 series are alike is to be estimated (false)
%     trials      1 x T or scalar, how many trials y is the mean of: the real
%                 material has a packing of its own too, Inf if sd holds that
%                 scatter (1)
%     scatter     1 x T logical, sd was found from the scatter of the trials and
%                 holds their packings: the larger of the two counts (false)
%     curve       1 x T, targets with one number > 0 are measured together, as
%                 one curve (0)
%     seedSd      1 x T, known scatter of one run over seeds (NaN: from data)
%     paramMean, paramSd   1 x p, values measured independently (NaN: none)
%     benchCost   1 x B, cost of one measurement on each bench (1)
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
  checkValues (problem);
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
  problem = struct ('sdKnown', true (1, T), 'held', false (1, T), ...
                    'series', zeros (1, T), ...
                    'coordinate', zeros (1, T), 'covariance', [], ...
                    'estimateSeries', false (1, T), 'trials', 1, ...
                    'scatter', false (1, T), 'curve', zeros (1, T), ...
                    'seedSd', NaN (1, T), ...
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
  problem.sdKnown = logical (problem.sdKnown);
  problem.estimateSeries = logical (problem.estimateSeries);
  problem.scatter = logical (problem.scatter);
  if isscalar (problem.trials)
    problem.trials = repmat (problem.trials, 1, T);
  end
end

function checkShapes (problem, T, p)
  wide = {'y', 'sd', 'bench', 'held', 'series', 'coordinate', ...
          'seedSd', 'targetNames', 'trials', 'estimateSeries', ...
          'sdKnown', 'scatter', 'curve'};
  for k = 1:numel (wide)
    if numel (problem.(wide{k})) ~= T
      error ('DEcalioc:newGapProblem:badShape', ...
             'newGapProblem: %s must be 1 x %d like Y, got %d values.', ...
             wide{k}, T, numel (problem.(wide{k})));
    end
  end
  for name = {'paramMean', 'paramSd'}
    if numel (problem.(name{1})) ~= p
      error ('DEcalioc:newGapProblem:badShape', ...
             ['newGapProblem: %s must be 1 x %d, one a parameter with NaN ' ...
              'for none, got %d values.'], name{1}, p, ...
             numel (problem.(name{1})));
    end
  end
  if numel (problem.names) ~= p || ~all (diff (problem.limits) > 0)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: LIMITS must be 2 x %d with the lower limit ' ...
            'first in every column.'], numel (problem.names));
  end
  C = problem.covariance;
  if ~isempty (C) && ~(isequal (size (C), [T, T]) && issymmetric (C, 1e-9))
    error ('DEcalioc:newGapProblem:badShape', ...
           ['newGapProblem: COVARIANCE must be %d x %d and symmetric, got ' ...
            'a %d x %d matrix.'], T, T, rows (C), columns (C));
  end
end

function checkValues (problem)
  cost = problem.benchCost;
  if numel (cost) < max (problem.bench) || ~all (cost > 0)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: BENCHCOST must hold %d numbers above 0, one a ' ...
            'bench, got %s.'], max (problem.bench), mat2str (cost, 4));
  end
  bad = problem.trials(~(problem.trials > 0));
  if ~isempty (bad)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: TRIALS must be above 0, got %g. Give the ' ...
            'number of trials that each value is the mean of, Inf where SD ' ...
            'holds their scatter.'], bad(1));
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
%! assert (problem.trials, [1, 1, 1]);
%! assert (problem.sdKnown, true (1, 3));
%! given.trials = 4;
%! assert (newGapProblem (given).trials, [4, 4, 4]);
%! given.trials = [1; 2; Inf];
%! assert (newGapProblem (given).trials, [1, 2, Inf]);
%! given.held = [false, true, false];
%! problem = newGapProblem (given);
%! assert (problem.used, 1);
%! assert (problem.heldOut, 2);
%!error id=DEcalioc:newGapProblem:missingField newGapProblem (struct ('y', 1))
%!error id=DEcalioc:newGapProblem:badShape
%! newGapProblem (struct ('y', [1, 2], 'sd', [1, 1], 'limits', [0; 1], ...
%!                        'bench', [1, 1], 'sdKnown', true));
%!error id=DEcalioc:newGapProblem:badShape
%! newGapProblem (struct ('y', 1, 'sd', 1, 'limits', [0; 1], 'bench', 1, ...
%!                        'paramMean', [1, 2], 'paramSd', [1, 1]));
%!error id=DEcalioc:newGapProblem:badShape
%! newGapProblem (struct ('y', [1, 2], 'sd', [1, 1], 'limits', [0; 1], ...
%!                        'bench', [1, 1], 'covariance', eye (3)));
%!error id=DEcalioc:newGapProblem:badShape
%! newGapProblem (struct ('y', [1, 2], 'sd', 1, 'limits', [0; 1], ...
%!                        'bench', [1, 1]));
%!error id=DEcalioc:newGapProblem:badValue
%! newGapProblem (struct ('y', 1, 'sd', 1, 'limits', [1; 0], 'bench', 1));
%!error id=DEcalioc:newGapProblem:badValue
%! newGapProblem (struct ('y', 1, 'sd', 1, 'limits', [0; 1], 'bench', 1, ...
%!                        'trials', 0));
%!error id=DEcalioc:newGapProblem:badShape
%! newGapProblem (struct ('y', [1, 2, 3], 'sd', [1, 1, 1], 'limits', [0; 1], ...
%!                        'bench', [1, 1, 1], 'trials', [1, 2]));
%!error id=DEcalioc:newGapProblem:badValue
%! newGapProblem (struct ('y', [1, 2], 'sd', [1, 1], 'limits', [0; 1], ...
%!                        'bench', [1, 2], 'benchCost', 1));
