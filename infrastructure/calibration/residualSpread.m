% RESIDUALSPREAD  Residual of the surrogate mean and its standard deviation.
%
% CALL: [r, s] = residualSpread (surrogates, problem, P)
%
% P     n x d  parameter sets
% r, s  n x T  (the noise of a run is not in s)
%
% See also: meetProbability, targetResidual

function [r, s] = residualSpread (surrogates, problem, P)
  [m, v] = predictSurrogate (surrogates, P);
  [r, slope] = targetResidual (problem, P, m);
  s = abs (slope) .* sqrt (v);
end
