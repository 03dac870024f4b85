% MEASUREDTARGET  Makes one target of the lines that measured it.
%
% CALL: [TARGET, FAULTS] = measuredTarget (TRIALS, MEANS)
%
%   TRIALS    1 x n struct of readMeasured, lines of one quantity, and places
%             (on how many places of its curve the name stands), mean (number)
%   MEANS     of varianceComponents
%   TARGET    one element of groups, see groupMeasured, but for changed
%   FAULTS    1 x p faults, reason measuredRepeats: what one trial says holds
%             for all, so they must not say two things

function [g, p] = measuredTarget (trials, means)
  p = checkAlike (trials);
  one = trials(1);
  g = struct ('line', one.line, 'file', one.file, 'model', one.model, ...
              'name', targetName (one), 'result', one.name, ...
              'series', one.series, 'at', one.at, ...
              'unit', firstOf (trials, 'unit'), ...
              'given', givenField (one, 'given', one.unit), 'value', NaN, ...
              'sd', max ([trials.sd]), 'trials', 1, 'scatter', false, ...
              'role', firstOf (trials, 'role'), ...
              'tol', firstOf (trials, 'tol'), ...
              'isAbsolute', firstOf (trials, 'isAbsolute'), ...
              'each', zeros (1, 0), 'shared', 0, 'days', [], ...
              'freedom', Inf, 'commonFreedom', Inf, 'sessionFreedom', Inf, ...
              'scatterRatio', NaN, 'scatterP', NaN, 'swept', false, ...
              'sessions', {{}}, 'mixed', false);
  g.shown = shownUnit (g);
  if isempty (g.role)
    g.role = 'calibrate';
  end
  if isempty (g.result)
    g.result = g.series;
  end
  trials = trials(isfinite ([trials.value]));
  if isempty (trials)
    g.role = 'unmeasured';
    return
  end
  weight = [trials.repeats];
  weight(isnan (weight)) = 1;
  g.each = [trials.value];
  g.mixed = any ([trials.sd] > 0) && ~all ([trials.sd] > 0);
  g.trials = countOf (trials, weight);
  g.sessions = {trials.session};
  own = means(trials(1).mean);
  for name = {'value', 'sd', 'shared', 'days', 'freedom', 'commonFreedom', ...
              'sessionFreedom', 'scatterRatio', 'scatterP', 'swept'}
    g.(name{1}) = own.(name{1});
  end
  % what trials scatter holds their packings; what is stated need not
  g.scatter = own.hasScatter && ~(isscalar (trials) && trials.sd > 0);
  g = withCommon (g, trials);
  g.isAbsolute = g.isAbsolute || (numel (trials) > 1 && g.value == 0);
end

% As the user has measured it.
function s = shownUnit (g)
  s = struct ('unit', g.unit, 'factor', 1);
  factor = unitFactor (g.given, g.unit);
  if ~isempty (g.given) && factor > 0
    s = struct ('unit', g.given, 'factor', factor);
  end
end

% What one trial says holds for all: it must not say two things.
function p = checkAlike (trials)
  p = checkFault ();
  if isscalar (trials)
    return
  end
  for field = {'role', 'tol', 'isAbsolute', 'unit'}
    given = trials(isGiven (trials, field{1}));
    for trial = given(2:end)
      if ~isequaln (trial.(field{1}), given(1).(field{1}))
        where = sprintf ('%s, line %d, %s', trial.file, trial.line, field{1});
        p(end + 1) = checkFault ('measuredRepeats', where, ...
                                 sprintf (['what line %d has: it is the ' ...
                                           'same quantity'], given(1).line), ...
                                 describeValue (trial.(field{1})), ...
                                 'Give it once, or alike in every trial.');
      end
    end
  end
end

function given = isGiven (trials, field)
  if strcmp (field, 'isAbsolute')
    field = 'tol';
  end
  given = ~arrayfun (@(o) isempty (o.(field)) || ...
                     any (isnan (double (o.(field)))), trials);
end

function value = firstOf (trials, field)
  if numel (trials) > 1
    trials = trials([find(isGiven (trials, field)), 1]);
  end
  value = trials(1).(field);
end

% Lines of one block of a session are one trial.
function n = countOf (trials, weight)
  n = sum (weight);
  inBlock = ~arrayfun (@(one) isempty (givenField (one, 'block', '')), trials);
  if any (inBlock)
    names = strcat ({trials(inBlock).session}, {'|'}, {trials(inBlock).block});
    n = sum (weight(~inBlock)) + numel (unique (names));
  end
end

% What trials have in common, such as the error of a balance; those of one session whose
% sd differ have none, and each counts by its own. The sd of the only line of a state is
% that of the mean already, see readingLines.
function g = withCommon (g, trials)
  isShared = ~isinf ([trials.repeats]);
  own = [trials(isShared).sd];
  if isscalar (trials) || ~any (own > 0)
    return
  elseif weighsEach (trials) && ~isscalar (unique (g.sessions))
    return                               % readingLines has weighed them
  elseif weighsEach (trials)
    [g.value, g.sd, between] = weightedMean (valuesOf (trials), own);
    g.scatter = between > 0;
    g.freedom = Inf;
    if g.scatter
      g.freedom = numel (own) - 1;
    end
    g.commonFreedom = g.freedom;
    g.sd = hypot (g.sd, g.shared);
  elseif g.scatter
    common = mean (own.^2);
    rest = g.sd^2 - g.shared^2;
    % Welch and Satterthwaite: the common part is known
    g.freedom = g.freedom * (1 + common / g.sd^2)^2;
    g.commonFreedom = g.commonFreedom * (1 + common / rest)^2;
    g.sd = sqrt (g.sd^2 + common);
  elseif ~(g.sd > 0)                     % alike to the last digit
    g.sd = sqrt (mean (own.^2));
  end
end

% Less what drifts with their order.
function values = valuesOf (trials)
  values = [trials.value];
  if isfield (trials, 'drift')
    values = values - [trials.drift];
  end
end

% Each line counts by its own sd, to which comes what they scatter beyond (Paule
% and Mandel 1982: the between-trial variance with which the weighted sum of
% squares is n - 1).
function [m, sd, s] = weightedMean (value, own)
  n = numel (value);
  meanOf = @(between) (value ./ (own.^2 + between)) * ones (n, 1) / ...
                       sum (1 ./ (own.^2 + between));
  excess = @(between) sum ((value - meanOf (between)).^2 ./ (own.^2 + between)) - (n - 1);
  between = 0;
  if excess (0) > 0
    between = fzero (excess, [0, n * max(max (value) - min (value), max (own))^2]);
  end
  m = meanOf (between);
  sd = 1 / sqrt (sum (1 ./ (own.^2 + between)));
  s = sqrt (between);
  if s > 0
    sd = sd * -studentQuantile (0.1587, n - 1);
  end
end

function name = targetName (row)
  name = row.name;
  if isempty (row.series)
    return
  end
  if isempty (name)
    name = row.series;
  elseif row.places == 1
    return
  end
  name = sprintf ('%s@%.6g', name, row.at);
end

%!test
%! line = struct ('line', 2, 'model', 1, 'name', '', 'series', 'w', ...
%!                'unit', 'kg', 'at', 3, 'value', {1, 3}, 'sd', 0, ...
%!                'repeats', NaN, 'role', '', 'tol', {NaN, 0.1}, ...
%!                'isAbsolute', false, 'file', 't.csv', 'session', '', ...
%!                'places', 1);
%! [line.mean] = deal (1);
%! means = struct ('value', 2, 'sd', 3, 'shared', 0, 'days', [], 'freedom', ...
%!                 1, 'commonFreedom', Inf, 'sessionFreedom', Inf, ...
%!                 'scatterRatio', NaN, 'scatterP', NaN, 'swept', false, ...
%!                 'hasScatter', true);
%! [g, p] = measuredTarget (line, means);
%! assert (isempty (p));
%! assert ({g.name, g.value, g.trials, g.tol}, {'w@3', 2, 2, 0.1});
%! assert ([g.scatter, g.shared, g.sd], [1, 0, 3]);
%! % a balance has an error of its own
%! [line.sd] = deal (4);
%! g = measuredTarget (line, means);
%! assert ([g.sd, g.freedom], [5, (25 / 9)^2], 1e-12);
%! line(2).unit = 'g';
%! [~, p] = measuredTarget (line, means);
%! assert (p.id, 'DEcalioc:checkCase:measuredRepeats');
%!test
%! % lines with an sd of their own count by it; what they scatter beyond counts, too
%! line = struct ('line', 2, 'model', 1, 'name', 'a', 'series', '', ...
%!                'unit', 'deg', 'at', NaN, 'value', {34, 30.1, 30.2}, ...
%!                'sd', {5, 0.1, 0.1}, 'repeats', NaN, 'role', '', 'tol', 0.1, ...
%!                'isAbsolute', false, 'file', 't.csv', 'session', '', ...
%!                'places', 1, 'mean', 1);
%! means = struct ('value', 94.3 / 3, 'sd', 1.3, 'shared', 0, 'days', [], 'freedom', ...
%!                 2, 'commonFreedom', Inf, 'sessionFreedom', Inf, ...
%!                 'scatterRatio', NaN, 'scatterP', NaN, 'swept', false, ...
%!                 'hasScatter', true);
%! g = measuredTarget (line, means);
%! w = 1 ./ [25, 0.01, 0.01];
%! assert ([g.value, g.sd], [w * [34; 30.1; 30.2], sqrt(sum (w))] / sum (w), 1e-12);
%! assert ({g.freedom, g.scatter}, {Inf, false});
%! assert (measuredTarget (line([2, 3, 1]), means).value, g.value, 1e-12);
%! [line.sd] = deal (0.1, 0.1, 0.2);
%! g = measuredTarget (line, means);
%! assert (g.value, 31.4, 0.1);
%! assert (g.sd > 1 && g.scatter && g.freedom == 2);
%! % alike: an error that they share, which their mean has as well
%! [line.sd] = deal (0.1);
%! assert (measuredTarget (line, means).value, 94.3 / 3, 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
