% LOOKAFTER  How long to wait before the next look at the runs under way.
%
% CALL: SECONDS = lookAfter (AGES, USUAL)
%
%   AGES     1 x n, how long each run has been under way (s); may be empty
%   USUAL    1 x n, length of the shortest run of its kind (s), NaN: not known
%   SECONDS  scalar, between 0.02 and 1
%
% A look costs part of a millisecond of processor time a run, and a run that has
% ended is seen at the next one. So it is looked often only when an end is due:
% every 1.5 % of its age from 0.7 of the usual length on, or from the start
% where that is not known; before, at half of the time until then.

function seconds = lookAfter (ages, usual)
  waits = max (0.02, 0.015 * ages);
  isEarly = ages < 0.7 * usual;
  waits(isEarly) = max (0.02, 0.5 * (0.7 * usual(isEarly) - ages(isEarly)));
  seconds = min ([waits, 1]);
  if isempty (ages)
    seconds = 0.02;
  end
end

%!assert (lookAfter ([], []), 0.02)
%!assert (lookAfter (0.5, NaN), 0.02)
%!assert (lookAfter ([700, 40], [NaN, NaN]), 0.6, eps)
%!assert (lookAfter ([700, 900], [NaN, 100]), 1)
%!assert (lookAfter ([1, 40], [2, 50]), 0.2, eps)
%!assert (lookAfter (1, 100), 1)
%!test
%! % few looks at a run of 30 s, and its end is not missed by a fiftieth
%! age = 0;
%! looks = 0;
%! while age < 30
%!   age = age + lookAfter (age, 29);
%!   looks = looks + 1;
%! end
%! assert (looks < 60);
%! assert (age < 30.5);

% SPDX-License-Identifier: GPL-3.0-only
