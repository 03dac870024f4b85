% ERRORFACTORS  What an error is larger by than a normal one of its deviation.
%
% CALL: F = errorFactors (WHITE, N)
%
%   WHITE  struct of whitenEmulator: nu (1 x T'), common (see logLikelihood)
%   N      how many data sets
%   F      N x T', drawn: one estimated variance a target makes Student's t of a normal
%          error, and a scale that few trials tell of is wrong for all targets at once

function F = errorFactors (white, n)
  nu = min (white.nu, 1e4);
  % normal over the root of chi-square / nu
  chi2 = 2 * randg (repmat (nu / 2, n, 1));
  F = 1 ./ sqrt (chi2 ./ nu .* white.common.stretch);
  at = white.common.at;
  freedom = white.common.freedom;
  if isfinite (freedom)
    F(:, at) = F(:, at) .* sqrt (freedom ./ (2 * randg (freedom / 2 * ones (n, 1))));
  end
end

%!test
%! % Student's t of 3 freedoms beside a normal error: the share beyond 3.18 is 5 % (sd of
%! % the share 0.15 %) and 0.15 %; a common scale is one for both
%! restore = seedRandom (1);
%! white = struct ('nu', [3, Inf], 'common', struct ('freedom', Inf, 'stretch', [1, 1], ...
%!                                                   'at', [true, true]));
%! far = mean (abs (randn (2e4, 2) .* errorFactors (white, 2e4)) > 3.1824);
%! assert (far, [0.05, 0.00146], [0.008, 0.0015]);
%! [white.nu, white.common.freedom, white.common.stretch] = deal ([Inf, Inf], 3, [1, 4]);
%! F = errorFactors (white, 100);
%! assert (F(:, 2), F(:, 1) / 2, 0.05 * F(:, 1));
%! assert (std (log (F(:, 1))) > 0.3);

% SPDX-License-Identifier: GPL-3.0-only
