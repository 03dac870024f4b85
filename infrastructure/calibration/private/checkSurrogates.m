% CHECKSURROGATES  Plain warnings about a calibration, one sentence each.
%
% CALL: [LINES, TOUCHED] = checkSurrogates (STATE, PROBLEM [, INTERVAL])
%
% INTERVAL 2 x d, of the parameters (NaN: not known, the default)
% LINES    cellstr: a source that is not used (keepApart), a target outside the
%          range of the responses, a surrogate with poor Q2, a parameter at its
%          limit, fewer targets than parameters, runs that failed, equal replicates,
%          runs of one set that are far apart, runs that were left out, a level
%          that was dropped
% TOUCHED  cellstr, parameters that stand at a limit, and whose interval comes as
%          near to it as it is wide: 2.9 to 3.1 is well inside 0 to 1000

function [lines, touched] = checkSurrogates (state, problem, interval)
  if nargin < 3
    interval = NaN (2, numel (problem.names));
  end
  [groups, names, isJoint] = requirementsOf (problem, 1:numel (problem.calibrate));
  lines = warningsOf (state, problem, [groups{~isJoint}]);
  for k = find (isJoint)
    whole = [countText(numel (groups{k}), 'point'), ' of ', names{k}];
    lines = [lines, oneWarning(warningsOf (state, problem, groups{k}), whole)];
  end
  touched = limitsTouched (state.found.params, interval, problem);
  if ~isempty (touched)
    lines{end + 1} = ['at a limit of the box: ', strjoin(touched, ', ')];
  end
  nTargets = sum (problem.calibrate);
  d = numel (problem.names);
  if nTargets < d
    lines{end + 1} = sprintf ('%s cannot fix %s: other values will do as well', ...
                              countText (nTargets, 'target'), countText (d, 'parameter'));
  end
  isOurs = ~ismember (state.data.stage, {'import', 'library'});
  failed = sum (lostRows (state.data.Z(isOurs, :), problem.bench));
  if failed > 0
    of = ['of ', countText(sum (isOurs), 'run'), ' failed and '];
    lines{end + 1} = countText (failed, [of, 'is left out'], [of, 'are left out']);
  end
  lines = [lines, lackingOne(state.data.Z, problem)];
  [~, isRepeat] = countEqualOnce (state.data, problem.bench);
  if any (isRepeat)
    lines{end + 1} = [countText(sum (isRepeat), 'run repeats', 'runs repeat'), ...
                      ' another one at the same set to the last digit: the model ' ...
                      'does not use runSeed. Such runs tell nothing of its scatter ' ...
                      'and are not counted'];
  end
  lines = [lines, apartLines(state, problem), badRuns(state, problem)];
  if ~isempty (problem.coarse)
    lines = [lines, droppedLevels(state, problem)];
  end
  lines = [{state.misled}(~isempty (state.misled)), lines];
end

% Runs of one set that differ by far more than runs scatter elsewhere: a second outcome,
% or a wrong run. What was left out has a line of its own.
function lines = apartLines (state, problem)
  lines = {};
  data = runsThatCount (state.data, problem);
  counted = all (state.data.E == problem.fine, 2);
  isOut = any (horzcat (state.surrogates.leftOut), 2);
  isOut(end + 1:rows (counted), 1) = false;
  data.Z(isOut(counted), :) = NaN;
  scatter = arrayfun (@(s) median (abs (s.looResidual)) / 0.6745, state.surrogates);
  [sets, ~, group] = unique (data.X, 'rows');
  for t = find (problem.calibrate)
    ends = @(f) accumarray (group(:), data.Z(:, t), [], f);
    [low, high] = deal (ends (@min), ends (@max));
    far = find (high - low > 6 * scatter(t) & ...
                high - low > 2 * problem.tol(t) * abs (problem.scale(t)));
    for k = far'
      values = struct ('name', problem.targetNames{t}, 'low', low(k), 'high', high(k), ...
                       'scatter', scatter(t), 'where', ...
                       namedValues (problem.names, sets(k, :), '%.4g'));
      lines{end + 1} = sentence ('warning.apart', values);
    end
  end
end

% Runs that lack one result count for the others they have.
function lines = lackingOne (Z, problem)
  lines = {};
  [lacks, hasAny] = lackingRows (Z, problem.bench);
  for t = find (any (lacks, 1))
    values = struct ('lacks', sum (lacks(:, t)), 'tried', sum (hasAny(:, t)), 'name', ...
                     problem.targetNames{t});
    lines{end + 1} = sentence ('warning.lacking', values);
  end
end

function lines = droppedLevels (state, problem)
  lines = {};
  coarse = problem.coarse;
  s = state.surrogates;
  L = rows (coarse.levels);
  where = @(k) namedValues (coarse.variables, coarse.levels(k, :));
  fine = runsThatCount (state.data, problem);
  if ~any (all (isfinite (fine.Z), 2))
    lines{1} = sprintf (['no run at the level that counts (%s): the set is ' ...
                         'that of coarser runs'], where (L));
  end
  for k = 1:L - 1
    units = arrayfun (@(t) unitLevel (coarse, coarse.levels(k, :), t), ...
                      1:numel (s));
    isDropped = arrayfun (@(s, units) any (s.dropped == units), s, units);
    names = {s(isDropped).name};
    if numel (names) > 3
      names = [names(1:3), sprintf('and %d more', numel (names) - 3)];
    end
    if ~isempty (names)
      lines{end + 1} = sprintf (['the runs at %s tell nothing of %s at the ' ...
                                 'last level: they are not used there'], ...
                                where (k), strjoin (names, ', '));
    end
  end
end

% Which runs the surrogates leave out, and which look wrong but count, as nobody
% could run them once more.
function lines = badRuns (state, problem)
  bad = any (horzcat (state.surrogates.leftOut), 2);
  lines = strcat (suspectLines (state, problem, find (bad)), ...
                  {', and so does a second run there: it is left out'});
  open = openSuspects (state, problem);
  lines = [lines, ...
           strcat(suspectLines (state, problem, find (open)), ...
                  {['. It could not be run once more with another seed, ' ...
                    'so it counts: it may be wrong, or show the way. ' ...
                    'Repeat it']})];
end

function lines = warningsOf (state, problem, targets)
  lines = {};
  for t = targets
    s = state.surrogates(t);
    value = problem.value(t);
    z = [s.z; s.aside];                  % a run that is left out was one, too
    ends = [min(z), max(z)];
    if value < ends(1) || value > ends(2)
      lines{end + 1} = sprintf (['target %s = %g lies outside what the ' ...
                                 'runs reached (%g to %g)'], s.name, value, ...
                                ends);
    end
    if ~isempty (s.warning)
      lines{end + 1} = sprintf ('%s: %s', s.name, s.warning);
    end
  end
end

% One sentence for all points that have something: the first one's.
function lines = oneWarning (lines, whole)
  if numel (lines) > 1
    lines = {sprintf('%s (and %d more warnings of the %s)', lines{1}, ...
                     numel (lines) - 1, whole)};
  end
end

function names = limitsTouched (params, interval, problem)
  u = toUnit (params(:)', problem.limits);
  near = problem.options.atLimit;
  ends = toUnit (interval, problem.limits);
  ends = [min([ends(1, :); u]); max([ends(2, :); u])];   % NaN: that of no width
  width = diff (ends);
  width(any (isnan (interval), 1)) = Inf;
  names = problem.names(u < near & ends(1, :) <= width | ...
                        u > 1 - near & 1 - ends(2, :) <= width);
end

%!shared problem, state, s, coarse
%! [problem, state, s] = smallCalibration ();
%! coarse = struct ('variables', {{'scaleP'}}, 'levels', [3; 2; 1], ...
%!                  'column', [1, 1]);
%!function hits = those (lines, part)
%!  hits = lines(~cellfun (@isempty, strfind (lines, part)));
%!endfunction

%!test
%! assert (isempty (checkSurrogates (state, problem)));
%! odd = problem;
%! odd.value(2) = 9;
%! odd.calibrate(1) = false;
%! failed = state;
%! failed.found.params = [1, 1];
%! failed.data.Z(3, 1) = NaN;
%! [lines, touched] = checkSurrogates (failed, odd);
%! assert (touched, {'a'});
%! assert (numel (lines), 4);
%! assert (lines{1}, ['target y = 9 lies outside what the runs reached ', ...
%!                    sprintf('(%g to %g)', min (s(2).z), max (s(2).z))]);
%! assert (lines{2}, 'at a limit of the box: a');

%!test
%! % runs that lack one result are named, and are no failed ones
%! clogged = state;
%! one = setfield (problem, 'bench', ones (size (problem.bench)));
%! clogged.data.Z(3:4, 1) = NaN;
%! lines = checkSurrogates (clogged, one);
%! assert (numel (those (lines, '2 of 12 runs lack x,')), 1);
%! assert (isempty (those (lines, 'failed')));
%!test
%! % near a limit, seen from the box, and far from it, seen from the interval
%! wide = setfield (state, 'found', 'params', [0.003, 1.996]);
%! touched = @(interval) nthargout (2, @checkSurrogates, wide, problem, interval);
%! assert (problem.limits, [0, 0; 1, 2]);
%! assert (touched ([0.0029, 1.99; 0.0031, 2]), {'b'});
%! assert (touched ([0.0029, 1.995; 0.0031, 1.997]), cell (1, 0));
%! assert (touched ([0, 1.9; 0.3, 1.998]), {'a', 'b'});
%! assert (touched (NaN (2, 2)), {'a', 'b'});
%!test
%! % the points of a curve have one sentence together
%! curve = problem;
%! curve.curve = [1, 1];
%! curve.seriesNames = {'w', 'w'};
%! curve.value = [99, 99];
%! lines = checkSurrogates (state, curve);
%! assert (numel (lines), 1);
%! assert (numel (those (lines, 'and 1 more warnings of the 2')), 1);

%!test
%! % a run that ended well but is wrong is named, with what the others say; one
%! % that nobody has run once more counts
%! wrong = state;
%! wrong.data.Z(3, :) = 1.5 * state.data.Z(3, :);
%! wrong.surrogates = fitSurrogates (wrong.data, problem);
%! lines = checkSurrogates (wrong, problem);
%! assert (numel (those (lines, 'so it counts: it may be wrong')), 1);
%! wrong.data = addRows (wrong.data, state.data.X(3, :), state.data.Z(3, :), ...
%!                       2, 'repeat');
%! wrong.surrogates = fitSurrogates (wrong.data, problem);
%! hit = those (checkSurrogates (wrong, problem), 'is left out');
%! assert (numel (hit), 1);
%! at = sprintf ('%s = %.4g', problem.names{1}, state.data.X(3, 1));
%! assert (numel (those (hit, at)), 1);

%!test
%! % two runs of one set that are far apart get a word
%! apart = state;
%! apart.data = addRows (state.data, state.data.X([3, 3, 4], :), ...
%!                       state.data.Z([3, 3, 4], :) .* [1, 1.001; 1, 1.2; 1, 1], ...
%!                       [2; 3; 2], 'verify');
%! apart.surrogates = fitSurrogates (apart.data, problem);
%! [apart.surrogates.leftOut] = deal (false (15, 1));
%! assert (numel (those (checkSurrogates (apart, problem), 'elsewhere runs scatter')), 1);
%! assert (isempty (those (checkSurrogates (state, problem), 'elsewhere runs scatter')));

%!test
%! % a level that was dropped is told with a word; without a run at the level
%! % that counts the set is that of coarser runs
%! problem.coarse = coarse;
%! state.surrogates(2).dropped = 1;
%! lines = checkSurrogates (state, problem);
%! assert (those (lines, 'scaleP = 3'), ...
%!         {['the runs at scaleP = 3 tell nothing of ', s(2).name, ...
%!           ' at the last level: they are not used there']});
%! assert (isempty (those (lines, 'scaleP = 2')));
%! problem.fine = 1;
%! state.data.E = 2 * ones (rows (state.data.X), 1);
%! lines = checkSurrogates (state, problem);
%! assert (numel (those (lines, 'coarser runs')), 1);

% SPDX-License-Identifier: GPL-3.0-only
