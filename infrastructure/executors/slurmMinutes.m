% SLURMMINUTES  Time limit that is asked of Slurm for an array.
%
% CALL: MINUTES = slurmMinutes (ASKED, LIMITS)
%
%   ASKED    Input.slurm.time (min), NaN = not given
%   LIMITS   1 x n time limits of the runs (s), NaN = none
%   MINUTES  whole number: ASKED; without it the longest of LIMITS and two
%            minutes more; one day where a run has none. A job never goes
%            without a limit: Slurm would keep one whose node has lost it for a
%            year.
%
% See also: slurmSubmit

function minutes = slurmMinutes (asked, limits)
  if ~isnan (asked)
    minutes = ceil (asked);
  elseif any (~isfinite (limits))
    minutes = 24 * 60;
  else
    minutes = ceil (max (limits) / 60) + 2;
  end
end

%!assert (slurmMinutes (90, [NaN, 1]), 90)
%!assert (slurmMinutes (NaN, [600, 601]), 13)
%!assert (slurmMinutes (NaN, [600, NaN]), 1440)
