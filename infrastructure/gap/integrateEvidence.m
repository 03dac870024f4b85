% INTEGRATEEVIDENCE  Integrates the likelihood over parameters and strength.
%
% CALL: RESULT = integrateEvidence (WHITE, H, Z, MODES, BOX, BASE)
%
%   WHITE   struct of whitenEmulator
%   H       1 x h, numbers of the active effects
%   Z       1 x T, whitened data
%   MODES   struct array Q (1 x d), A (d x d): where the mass is expected
%   BOX     struct of hypothesisBox
%   BASE    struct of integrationPoints
%   RESULT  struct
%     logE (log evidence), error (Monte Carlo standard deviation of logE), ess
%     Q (N x d), weight (N x 1, sum 1): the posterior
%
% Importance sampling from Student t (5) at the modes (90 %) and the box (10 %);
% every variance changes with the point. logE = log mean of likelihood x prior /
% proposal.
%
% See also: proposalPoints, fitHypothesis, weighCase

function result = integrateEvidence (white, h, z, modes, box, base)
  points = proposalPoints (modes, box, base);
  Q = points.Q;
  [M, V] = predictGap (white, h, Q);
  logLike = -0.5 * sum ((z - M).^2 ./ V + log (2 * pi * V), 2);
  logPrior = sum (box.logConstant) - ...
             0.5 * sum (box.precision .* (Q - box.mean).^2, 2);
  logW = logLike + logPrior - points.logP;
  N = rows (base.normal);
  total = logSumExp (logW');
  w = exp (logW - total);
  result = struct ('logE', total - log (N), 'ess', 1 / sum (w.^2));
  result.error = sqrt (max (sum (w.^2) - 1 / N, 0));
  result.Q = Q;
  result.weight = w;
end

%!test
%! % Gaussian in a wide box: evidence known in closed form (error < 0.1: the
%! % Monte Carlo deviation is printed as 0.03, chance of failing below 1 %)
%! white = struct ('p', 1, 'powers', [0; 1], 'coef', [0, 0; 20, 20], ...
%!                 'varPowers', 0, 'varCoef', [0, 0], 'effect', []);
%! prior = struct ('mean', 0, 'precision', 0, 'widen', 1);
%! box = hypothesisBox (white, [], prior);
%! base = integrationPoints (1000, 1, 3);
%! mode = struct ('Q', 0.1, 'A', 800);
%! r = integrateEvidence (white, [], [2, 2], mode, box, base);
%! exact = -log (2 * pi) + 0.5 * log (2 * pi / 800) - log (2);
%! assert (r.logE, exact, 0.1);
%! assert (r.ess > 200);
