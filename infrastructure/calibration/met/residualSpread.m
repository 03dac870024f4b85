% RESIDUALSPREAD  Residual of the surrogate mean and its standard deviation.
%
% CALL: [R, S] = residualSpread (SURROGATES, PROBLEM, P)
%
% P     n x d  parameter sets
% R, S  n x T  (the noise of a run is not in s)

function [r, s] = residualSpread (surrogates, problem, P)
  n = max (nargout, 1);              % the variance costs most of the time
  [moments{1:n}] = predictSurrogate (surrogates, P);
  [known{1:n}] = targetResidual (problem, P, moments{1});
  r = known{1};
  if n > 1
    s = abs (known{2}) .* sqrt (moments{2});
  end
end

%!test
%! % in shares of the targets 4 and 2
%! [problem, ~, s] = smallCalibration ();
%! [r, spread] = residualSpread (s, problem, [0.5, 1; 0.2, 0.1]);
%! [m, v] = predictSurrogate (s, [0.5, 1; 0.2, 0.1]);
%! assert (r, m ./ [4, 2] - 1, 1e-12);
%! assert (spread, sqrt (v) ./ [4, 2], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
