% SCATTEROFCHANGE  Whether trials of a change scatter more than the reference's.
%
% CALL: [RATIO, P] = scatterOfChange (VALUES, SESSIONS, VARIANCE, FREEDOM)
%
%   VALUES, SESSIONS  n x 1, trials of one quantity in the change, and the number of
%                     the session of each
%   VARIANCE, FREEDOM  of a trial, as the reference tells it
%   RATIO    standard deviation within sessions over that of the reference (NaN:
%            fewer than four trials beside the means of their sessions)
%   P        two-sided, of a ratio as far from 1 where nothing has changed
%
% The trial farthest from the mean of its session is left out: one slip of the hand
% is no scatter. The logarithm of a standard deviation of d freedoms errs by 1 /
% sqrt (2 d), and from session to session by 0.35 more (a factor of 1.4; assumed).

function [ratio, p] = scatterOfChange (values, sessions, variance, freedom)
  [ratio, p] = deal (NaN);
  sets = numel (unique (sessions));
  if numel (values) - sets < 4 || ~(variance > 0)
    return
  end
  [~, ~, of] = unique (sessions);
  middle = accumarray (of, values) ./ accumarray (of, 1);
  [~, far] = max (abs (values - middle(of)));
  values(far) = [];
  of(far) = [];
  middle = accumarray (of, values, [sets, 1]) ./ ...
           max (accumarray (of, 1, [sets, 1]), 1);
  df = numel (values) - numel (unique (of));
  ratio = sqrt (sumsq (values - middle(of)) / df / variance);
  sd = sqrt (0.5 / df + 0.5 / freedom + 2 * 0.35^2);
  p = 2 * normalTail (abs (log (max (ratio, realmin))) / sd);
end

%!test
%! % nine times the scatter is seen, one odd trial is not
%! values = [1; -1; 1; -1; 1; -1; 1; -1];
%! [ratio, p] = scatterOfChange (9 * values, 1 + 0 * values, 8 / 7, 20);
%! assert (ratio, 9, 0.3);
%! assert (p < 1e-3);
%! values(1) = 30;
%! [ratio, p] = scatterOfChange (values, 1 + 0 * values, 8 / 7, 20);
%! assert (ratio, 1, 0.1);
%! assert (p > 0.5);
%! assert (scatterOfChange ([1; 5; 9], [1; 1; 1], 1, 9), NaN);
%! % the means of sessions are no scatter
%! values = [1; -1; 1; -1; 1; 31; 29; 31; 29; 31];
%! sessions = [1; 1; 1; 1; 1; 2; 2; 2; 2; 2];
%! assert (scatterOfChange (values, sessions, 1, 9), 1, 0.2);
