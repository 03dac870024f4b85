% RESIDUALSPREAD  Residual of the surrogate mean and its standard deviation.
%
% CALL: [R, S] = residualSpread (SURROGATES, PROBLEM, P)
%
% P     n x d  parameter sets
% R, S  n x T  (the noise of a run is not in s)

function [r, s] = residualSpread (surrogates, problem, P)
  [m, v] = predictSurrogate (surrogates, P);
  [r, slope] = targetResidual (problem, P, m);
  s = abs (slope) .* sqrt (v);
end
