% BATCHMINUTES  Time limit that is asked of a queue for an array of runs.
%
% CALL: MINUTES = batchMinutes (ASKED, LIMITS)
%
%   ASKED    field time of the executor (min), NaN where it is not given
%   LIMITS   1 x n, time limits of the runs (s), NaN or Inf: a run has none
%   MINUTES  ASKED; without it the longest limit and two minutes more, one day
%            where a run has none (integer)
%
% A job never goes without: a queue might keep a lost one for a year.

function minutes = batchMinutes (asked, limits)
  if ~isnan (asked)
    minutes = ceil (asked);
  elseif any (~isfinite (limits))
    minutes = 24 * 60;
  else
    minutes = ceil (max (limits) / 60) + 2;
  end
end

%!assert (batchMinutes (1.5, [7, NaN]), 2)
%!assert (batchMinutes (NaN, [7, 61]), 4)
%!assert (batchMinutes (NaN, [7, NaN]), 1440)

% SPDX-License-Identifier: GPL-3.0-only
