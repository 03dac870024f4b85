% BATCHMINUTES  Time limit that is asked of a queue for an array.
%
% CALL: MINUTES = batchMinutes (ASKED, LIMITS)
%
%   ASKED    field time of Input.<queue> (min), NaN = not given
%   LIMITS   1 x n time limits of the runs (s), NaN = none
%   MINUTES  whole number: ASKED; without it the longest of LIMITS and two
%            minutes more; one day where a run has none. A job never goes
%            without a limit: a queue might keep one whose node has lost it
%            for a year.
%
% See also: batchSubmit

function minutes = batchMinutes (asked, limits)
  if ~isnan (asked)
    minutes = ceil (asked);
  elseif any (~isfinite (limits))
    minutes = 24 * 60;
  else
    minutes = ceil (max (limits) / 60) + 2;
  end
end

%!assert (batchMinutes (90, [NaN, 1]), 90)
%!assert (batchMinutes (NaN, [600, 601]), 13)
%!assert (batchMinutes (NaN, [600, NaN]), 1440)
