% MEANOFSESSIONS  Mean of trials of which those of one session share an error.
%
% CALL: [VALUE, SD, SHARED] = meanOfSessions (TRIALS, RATIO)
%
%   TRIALS  1 x n struct of readMeasured, measured lines of one quantity
%   RATIO   standard deviation between sessions over that of a trial within one
%   VALUE   mean, in which a session of few trials counts less
%   SD      standard uncertainty of VALUE (0: not known); where the lines of a
%           session tell its scatter, their sd is what they have in common, as in
%           groupMeasured, and counts beside it
%   SHARED  the part of it that the sessions make, which more trials in them
%           would leave as it is
%
% With s the standard deviation of a trial within its session and n_i trials in
% session i, the mean of a session has the variance s^2 (RATIO^2 + 1 / n_i);
% VALUE weighs by its inverse. SD has the factor t of groupMeasured. s is that of
% the lines of a session; where each session has one line, that of its sd, which
% is the uncertainty of the mean of its repeats. Where there is neither, the
% scatter of the sessions is all that is known.
%
% See also: sessionRatio, trialScatter

function [value, sd, shared] = meanOfSessions (trials, ratio)
  [within, means, counts, df] = trialScatter (trials);
  common = mean ([trials.sd]) * isfinite (df);
  n = numel (means);
  if within > 0
    weight = 1 ./ (ratio^2 + 1 ./ counts);
    sd = sqrt (within / sum (weight)) * factorOf (df + n - 1);
    shared = sd * ratio * sqrt (sumsq (weight) / sum (weight));
  else
    weight = ones (1, n);
    sd = std (means) / sqrt (n) * factorOf (n - 1);
    shared = sd;
  end
  value = means * weight' / sum (weight);
  sd = hypot (sd, common);
end

% Of few trials that know their own scatter badly, see groupMeasured.
function t = factorOf (df)
  t = 1;
  if df > 0 && isfinite (df)
    t = -studentQuantile (0.1587, df);
  end
end

%!function trials = of (varargin)
%!  trials = struct ('session', varargin(1:2:end), ...
%!                   'value', varargin(2:2:end), 'sd', 0, 'repeats', NaN);
%!endfunction
%!test
%! % two sessions of four and one trials; sessions scatter as trials do: weights
%! % 1 / (1 + 1/4) and 1 / 2, s^2 = 2/3, t of four degrees of freedom
%! trials = of ('a', 1, 'a', 2, 'a', 2, 'a', 3, 'b', 7);
%! [value, sd, shared] = meanOfSessions (trials, 1);
%! assert (value, (0.8 * 2 + 0.5 * 7) / 1.3, 1e-12);
%! t = -studentQuantile (0.1587, 4);
%! assert (sd, t * sqrt (2 / 3 / 1.3), 1e-12);
%! assert (shared, t * sqrt (2 / 3 * (0.64 + 0.25)) / 1.3, 1e-12);
%!test
%! % without a difference between sessions: the plain mean of all trials
%! trials = of ('a', 1, 'a', 3, 'b', 5);
%! [value, sd, shared] = meanOfSessions (trials, 0);
%! assert ([value, shared], [3, 0], 1e-12);
%! [trials.sd] = deal (0.7);
%! [~, with] = meanOfSessions (trials, 0);
%! assert (with, hypot (sd, 0.7), 1e-12);
%!test
%! % one line a session: its sd and repeats tell the scatter of a trial
%! trials = of ('a', 1, 'b', 2);
%! [trials.sd] = deal (0.1);
%! [trials.repeats] = deal (4);
%! [value, sd, shared] = meanOfSessions (trials, 2);
%! assert (value, 1.5, 1e-12);
%! assert ([sd, shared], 0.2 * sqrt ([4.25, 4] / 2), 1e-12);
%! % neither: the scatter of the sessions
%! [~, sd, shared] = meanOfSessions (of ('a', 1, 'b', 2), 2);
%! assert ([sd, shared], [1, 1] * 1.84 / 2, 2e-3);
%! % one reading is all there is
%! [value, sd, shared] = meanOfSessions (of ('a', 4), 2);
%! assert ([value, sd, shared], [4, 0, 0]);
