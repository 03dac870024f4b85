% MEASUREDTARGET  Makes one target of the lines that measured it.
%
% CALL: [TARGET, FAULTS] = measuredTarget (TRIALS, SESSIONS)
%
%   TRIALS    1 x n struct of readMeasured, lines of one quantity, and places
%             (on how many places of its curve the name stands)
%   SESSIONS  see sessionRatio
%   TARGET    one element of groups, see groupMeasured, but for changed
%   FAULTS    1 x p faults, reason measuredRepeats: what one trial says holds
%             for all, so they must not say two things

function [g, p] = measuredTarget (trials, sessions)
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
              'each', zeros (1, 0), 'shared', 0, 'sessions', {{}});
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
  g.trials = sum (weight);
  g.sessions = unique ({trials.session});
  if sessions.given
    [g.value, g.sd, g.shared] = meanOfSessions (trials, sessions.ratio);
    s = numel (trials) > numel (g.sessions) && any (diff (g.each));
  else
    [g.value, g.sd, s] = meanOfTrials (trials, min (weight, 1e6));
  end
  g.scatter = s > 0;
  g.isAbsolute = g.isAbsolute || (numel (trials) > 1 && g.value == 0);
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

function [m, sd, s] = meanOfTrials (trials, weight)
  value = [trials.value];
  own = [trials.sd];
  if all (own > 0) && any (own ~= own(1))
    [m, sd, s] = weightedMean (value, own);
    return
  end
  m = value * weight' / sum (weight);
  sd = mean (own);
  s = 0;
  n = numel (trials);
  if n > 1
    s = sqrt (weight / mean (weight) * (value - m)'.^2 / (n - 1));
    sd = hypot (-studentQuantile (0.1587, n - 1) * s / sqrt (n), sd);
  end
end

% Lines whose sd differ have no error in common: each counts by its own, to which
% comes what they scatter beyond (Paule and Mandel 1982: the between-trial variance
% with which the weighted sum of squares is n - 1).
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
%! [g, p] = measuredTarget (line, struct ('given', false));
%! assert (isempty (p));
%! assert ({g.name, g.value, g.trials, g.tol}, {'w@3', 2, 2, 0.1});
%! assert ([g.scatter, g.shared], [1, 0]);
%! line(2).unit = 'g';
%! [~, p] = measuredTarget (line, struct ('given', false));
%! assert (p.id, 'DEcalioc:checkCase:measuredRepeats');
%!test
%! % lines with an sd of their own count by it; what they scatter beyond counts, too
%! line = struct ('line', 2, 'model', 1, 'name', 'a', 'series', '', ...
%!                'unit', 'deg', 'at', NaN, 'value', {34, 30.1, 30.2}, ...
%!                'sd', {5, 0.1, 0.1}, 'repeats', NaN, 'role', '', 'tol', 0.1, ...
%!                'isAbsolute', false, 'file', 't.csv', 'session', '', ...
%!                'places', 1);
%! g = measuredTarget (line, struct ('given', false));
%! w = 1 ./ [25, 0.01, 0.01];
%! assert ([g.value, g.sd], [w * [34; 30.1; 30.2], sqrt(sum (w))] / sum (w), 1e-12);
%! assert (measuredTarget (line([2, 3, 1]), struct ('given', false)).value, g.value, ...
%!         1e-12);
%! [line.sd] = deal (0.1, 0.1, 0.2);
%! g = measuredTarget (line, struct ('given', false));
%! assert (g.value, 31.4, 0.1);
%! assert (g.sd > 1 && g.scatter);
%! % alike: an error that they share, beside their mean
%! [line.sd] = deal (0.1);
%! assert (measuredTarget (line, struct ('given', false)).value, 94.3 / 3, 1e-12);
