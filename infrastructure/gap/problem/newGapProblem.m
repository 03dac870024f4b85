% NEWGAPPROBLEM  Fills and checks the description of a diagnosis on matrices.
%
% CALL: GAPPROBLEM = newGapProblem (GIVEN)
%
%   GIVEN       struct; required fields
%     value    1 x T, measured values; NaN = simulated but not (yet) measured
%     sd       1 x T, standard uncertainty of value
%     limits   2 x p, or 3 x p, box of the calibrated parameters (toUnit)
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
%     trials      1 x T or scalar, how many trials value is the mean of: the
%                 real material has a packing of its own too, Inf if sd holds
%                 that scatter (1)
%     scatter     1 x T logical, sd was found from the scatter of the trials and
%                 holds their packings: the larger of the two counts (false)
%     shared      1 x T, the part of sd that a whole series shares, as its
%                 values are of the same sessions (0)
%     reading     1 x T cellstr, what one rule reads off ('': nobody says it)
%     curve       1 x T, targets with one number > 0 are measured together, as
%                 one curve (0)
%     noiseSd     1 x T, known noise of one run (NaN: from data)
%     paramMean, paramSd   1 x p, values measured independently (NaN: none)
%     benchCost   1 x B, cost of one measurement on each bench (1)
%     effects     1 x K struct, see newEffect ([])
%     causes      1 x n struct of listCauses, what may make several effects ([])
%     reference   struct, the same measured where every effect is neutral:
%                 value, sd, trials, scatter (1 x T; NaN: not measured there),
%                 and perCondition (1 x p logical, parameters that are other
%                 ones there); the diagnosis is one of the change then ([])
%   GAPPROBLEM  the same with every field present, rows as rows, and used,
%     heldOut, possible (numbers of targets), kept, unit (see enterRuns),
%     paramPrior (struct mean, sd: 1 x p in [-1, 1]; sd Inf: uniform)
%
% Errors: DEcalioc:newGapProblem:missingField, :badShape, :badValue
%
% See also: diagnoseMatrices, newEffect

function gapProblem = newGapProblem (given)
  needed = {'value', 'sd', 'limits', 'bench'};
  for k = 1:numel (needed)
    if ~isfield (given, needed{k})
      error ('DEcalioc:newGapProblem:missingField', ...
             'newGapProblem: GIVEN must have the field %s.', needed{k});
    end
  end
  T = numel (given.value);
  p = columns (given.limits);
  gapProblem = withDefaults (given, T, p);
  gapProblem.effects = arrayfun (@(e) newEffect (e, T), gapProblem.effects(:)');
  checkShapes (gapProblem, T, p);
  if ~isempty (gapProblem.effects)
    checkNames ({gapProblem.effects.name});
  end
  checkValues (gapProblem);
  gapProblem.used = find (isfinite (gapProblem.value) & ~gapProblem.held);
  gapProblem.heldOut = find (isfinite (gapProblem.value) & gapProblem.held);
  gapProblem.possible = find (~isfinite (gapProblem.value));
  gapProblem.paramPrior = priorOf (gapProblem);
  gapProblem.kept = 1:T;
  gapProblem.unit = ones (1, T);
  if isempty (gapProblem.used)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: VALUE must hold at least one measured value ' ...
            'that is not held out, got none.']);
  end
end

function prior = priorOf (gapProblem)
  mean_ = gapProblem.paramMean;
  limits = gapProblem.limits;
  prior.mean = toSymmetric (mean_, limits);
  prior.sd = 2 * gapProblem.paramSd ./ boxWidth (limits, mean_);
  without = ~isfinite (prior.mean) | ~isfinite (prior.sd);
  prior.mean(without) = 0;
  prior.sd(without) = Inf;
end

function gapProblem = withDefaults (given, T, p)
  B = max (given.bench);
  numbered = @(word, n) arrayfun (@(k) sprintf ('%s%d', word, k), 1:n, ...
                                  'UniformOutput', false);
  gapProblem = struct ('sdKnown', true (1, T), 'held', false (1, T), ...
                       'series', zeros (1, T), ...
                       'coordinate', zeros (1, T), 'covariance', [], ...
                       'estimateSeries', false (1, T), 'trials', 1, ...
                       'scatter', false (1, T), 'curve', zeros (1, T), ...
                       'shared', zeros (1, T), ...
                       'noiseSd', NaN (1, T), ...
                       'paramMean', NaN (1, p), 'paramSd', NaN (1, p), ...
                       'benchCost', ones (1, B), 'effects', [], ...
                       'causes', [], 'reference', []);
  gapProblem.targetNames = numbered ('t', T);
  gapProblem.benchNames = numbered ('bench', B);
  gapProblem.names = numbered ('p', p);
  gapProblem.reading = repmat ({''}, 1, T);
  fields = fieldnames (given);
  for k = 1:numel (fields)
    value = given.(fields{k});
    if (isnumeric (value) || islogical (value) || iscell (value)) && ...
       isvector (value)
      value = reshape (value, 1, []);
    end
    gapProblem.(fields{k}) = value;
  end
  gapProblem.limits = reshape (gapProblem.limits, [], p);
  gapProblem.held = logical (gapProblem.held);
  gapProblem.sdKnown = logical (gapProblem.sdKnown);
  gapProblem.estimateSeries = logical (gapProblem.estimateSeries);
  gapProblem.scatter = logical (gapProblem.scatter);
  if isscalar (gapProblem.trials)
    gapProblem.trials = repmat (gapProblem.trials, 1, T);
  end
end

function checkShapes (gapProblem, T, p)
  wide = {'value', 'sd', 'bench', 'held', 'series', 'coordinate', ...
          'noiseSd', 'targetNames', 'trials', 'estimateSeries', ...
          'sdKnown', 'scatter', 'curve', 'shared', ...
          'reading'};
  for k = 1:numel (wide)
    if numel (gapProblem.(wide{k})) ~= T
      error ('DEcalioc:newGapProblem:badShape', ...
             'newGapProblem: %s must be 1 x %d like VALUE, got %d values.', ...
             wide{k}, T, numel (gapProblem.(wide{k})));
    end
  end
  for name = {'paramMean', 'paramSd'}
    if numel (gapProblem.(name{1})) ~= p
      error ('DEcalioc:newGapProblem:badShape', ...
             ['newGapProblem: %s must be 1 x %d, one a parameter with NaN ' ...
              'for none, got %d values.'], name{1}, p, ...
             numel (gapProblem.(name{1})));
    end
  end
  limits = gapProblem.limits;
  if numel (gapProblem.names) ~= p || ~all (limits(1, :) < limits(2, :))
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: LIMITS must be 2 x %d with the lower limit ' ...
            'first in every column.'], numel (gapProblem.names));
  end
  C = gapProblem.covariance;
  if ~isempty (C) && ~(isequal (size (C), [T, T]) && issymmetric (C, 1e-9))
    error ('DEcalioc:newGapProblem:badShape', ...
           ['newGapProblem: COVARIANCE must be %d x %d and symmetric, got ' ...
            'a %d x %d matrix.'], T, T, rows (C), columns (C));
  end
end

% Results are kept by these names, as fields.
function checkNames (names)
  fields = cellfun (@(n) matlab.lang.makeValidName (n), names, ...
                    'UniformOutput', false);
  reserved = names(ismember (fields, {'null', 'unlisted'}));
  if ~isempty (reserved)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: no effect may be called %s, the name of a ' ...
            'probability of its own. Call it something else.'], reserved{1});
  end
  [~, first] = unique (fields, 'first');
  again = setdiff (1:numel (names), first);
  if ~isempty (again)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: names of effects must differ, as names of ' ...
            'variables too, got %s twice.'], names{again(1)});
  end
  both = find (~cellfun (@isempty, strfind (names, ' + ')), 1);
  if ~isempty (both)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: ''%s'' is no name of an effect, '' + '' joins ' ...
            'the names of two. Leave it out.'], names{both});
  end
end

function checkValues (gapProblem)
  cost = gapProblem.benchCost;
  if numel (cost) < max (gapProblem.bench) || ~all (cost > 0)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: BENCHCOST must hold %d numbers above 0, one a ' ...
            'bench, got %s.'], max (gapProblem.bench), mat2str (cost, 4));
  end
  bad = gapProblem.trials(~(gapProblem.trials > 0));
  if ~isempty (bad)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: TRIALS must be above 0, got %g. Give the ' ...
            'number of trials that each value is the mean of, Inf where SD ' ...
            'holds their scatter.'], bad(1));
  end
  if ~all (gapProblem.sd(isfinite (gapProblem.value)) >= 0)
    error ('DEcalioc:newGapProblem:badValue', ...
           ['newGapProblem: SD must be >= 0 for every measured target. ' ...
            'Give the standard uncertainty of each measurement.']);
  end
end

%!test
%! given = struct ('value', [1, 2, NaN], 'sd', [1, 1, 1], 'limits', [0; 1], ...
%!                 'bench', [1, 1, 2]);
%! gapProblem = newGapProblem (given);
%! assert (gapProblem.used, [1, 2]);
%! assert (gapProblem.possible, 3);
%! assert (gapProblem.benchNames, {'bench1', 'bench2'});
%! assert (gapProblem.trials, [1, 1, 1]);
%! assert (gapProblem.sdKnown, true (1, 3));
%! given.trials = 4;
%! assert (newGapProblem (given).trials, [4, 4, 4]);
%! given.trials = [1; 2; Inf];
%! assert (newGapProblem (given).trials, [1, 2, Inf]);
%! given.held = [false, true, false];
%! gapProblem = newGapProblem (given);
%! assert (gapProblem.used, 1);
%! assert (gapProblem.heldOut, 2);
%! given.limits = [0, 2; 1, 6];
%! [given.paramMean, given.paramSd] = deal ([0.75, NaN], [0.1, NaN]);
%! assert (newGapProblem (given).paramPrior, ...
%!         struct ('mean', [0.5, 0], 'sd', [0.2, Inf]), 1e-12);
%!test
%! % what is no description, and names that would write over each other, or over
%! % a probability
%! given = struct ('value', [1, 2], 'sd', [1, 1], 'limits', [0; 1], ...
%!                 'bench', [1, 1]);
%! wrong = {'sdKnown', true, 'sdKnown must be 1 x 2'; ...
%!          'sd', 1, 'sd must be 1 x 2'; ...
%!          'trials', [1, 2, 3], 'trials must be 1 x 2'; ...
%!          'paramMean', [1, 2], 'paramMean must be 1 x 1'; ...
%!          'covariance', eye(3), 'COVARIANCE must be 2 x 2'; ...
%!          'limits', [1; 0], 'lower limit first'; ...
%!          'trials', 0, 'TRIALS must be above 0'; ...
%!          'benchCost', -1, 'BENCHCOST must hold 1'; ...
%!          'held', [true, true], 'at least one measured'; ...
%!          'sd', [1, -1], 'SD must be >= 0'}';
%! for one = wrong
%!   bad = setfield (given, one{1:2});
%!   fail ('newGapProblem (bad);', one{3});
%! end
%! fail ('newGapProblem (rmfield (given, ''sd''));', 'must have the field sd');
%! for names = {{'null', 'b'}, {'unlisted', 'b'}, {'a', 'a'}, ...
%!              {'a-b', 'a_b'}, {'a + b', 'c'}}
%!   given.effects = struct ('name', names{1}, 'laboratory', true);
%!   fail ('newGapProblem (given);', 'newGapProblem: ');
%! end
