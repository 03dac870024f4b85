% CHANGEOFREADINGS  What has changed in each reading, without any model.
%
% CALL: [P, SD, SEEN] = changeOfReadings (PROBLEM, CHANGE)
%
%   PROBLEM  struct of newProblem, of a change
%   CHANGE   struct of emulateChange: fresh, before
%   P        1 x T, chance that noise alone makes a difference this large (NaN: not
%            measured in both)
%   SD       1 x T, of the difference (68 %), as sdOfChange, and of the packings that a
%            stated sd does not hold
%   SEEN     1 x T, as sdOfChange: what would show in 8 of 10 cases
%
% Student's t; degrees of freedom after Welch and Satterthwaite.
%
% See also: sdOfChange, readingsAlone

function [p, sd, seen] = changeOfReadings (problem, change)
  reference = problem.reference;
  packings = diag (change.fresh + change.before)' - problem.sd.^2 - reference.sd.^2;
  problem.days = ones (numel (problem.value), 1);
  reference.days = diag (reference.together);
  [sd, freedom, seen] = sdOfChange (problem, reference, max (packings, 0));
  t = (problem.value - reference.value) ./ sd .* studentFactor (min (freedom, 1e6));
  % a normal error has no end of its degrees of freedom
  freedom = min (freedom, 1e6);
  p = NaN (size (t));
  isThere = isfinite (t);
  f = freedom(isThere);
  p(isThere) = betainc (f ./ (f + t(isThere).^2), f / 2, 0.5);
end

%!shared given, change
%! given = struct ('value', [3, 0, NaN], 'sd', [1, 1, 1], 'limits', [0; 1], ...
%!                 'bench', [1, 1, 1]);
%! given.reference = struct ('value', [0, 0, 0], 'sd', [1, 1, 1]);
%! change = struct ('fresh', eye (3), 'before', eye (3));
%!test
%! [p, sd, seen] = changeOfReadings (newProblem (given), change);
%! assert (seen, sqrt (2) * (1.95996 + 0.84162) * [1, 1, 1], 1e-3);
%! assert (sd, sqrt (2) * [1, 1, 1], 1e-12);
%! assert (p(1:2), [2 * normalTail(3 / sqrt (2)), 1], 1e-4);
%! assert (isnan (p(3)));
%!test
%! % few trials tell less: three of each state, t of Welch, sd as half-widths of 68 %
%! few = given;
%! few.freedom = few.reference.freedom = 2 * ones (1, 3);
%! few.sd = few.reference.sd = studentFactor (2) * ones (1, 3);
%! wide = studentFactor (2)^2 * eye (3);
%! p = changeOfReadings (newProblem (few), struct ('fresh', wide, 'before', wide));
%! assert (p(1) > 0.05 && p(1) < 0.2);
%!test
%! % readings of the same sessions share what these bring
%! given.shared = given.reference.shared = [0.9, 0, 0];
%! given.reference.together = diag ([0.81, 0, 0]);
%! [~, sd] = changeOfReadings (newProblem (given), change);
%! assert (sd(1), sqrt (2 * 0.19), 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
