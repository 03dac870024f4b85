% INTEGRATEEVIDENCE  Integrates likelihood times prior over all unknowns.
%
% CALL: RESULT = integrateEvidence (WHITE, H, Z, MODES, SETTINGS)
%
%   WHITE     struct of whitenEmulator;  H  struct of newHypothesis
%   Z         1 x T, whitened data
%   MODES     struct array U (1 x d), A (d x d): where the mass is expected
%   SETTINGS  struct prior (see viewHypothesis), seed, points (of the first
%             draw), effective (points wanted), most (points drawn at most),
%             caution
%   RESULT    struct
%     logE (log evidence), error (its Monte Carlo standard deviation), ess
%     (effective number of points), points (number drawn)
%     Q (N x d), weight (N x 1, sum 1): the posterior
%     cautious (N x 1): the same with the likelihood to the power
%     SETTINGS.caution, for intervals
%
% Adaptive importance sampling (Cornuet, Marin, Mira and Robert 2012): Student t
% mixtures, first at the modes, then at the moments of all points so far, each
% with a tenth of the prior; the weight of a point is its density over the mean
% of all proposals that were used. Where few points carry the weight, the
% moments are those of flattened weights (Koblents and Miguez 2015), so that a
% collapsed sample walks to the mass instead of shrinking to its best point.

function result = integrateEvidence (white, h, z, modes, settings)
  view = viewHypothesis (white, h, settings.prior);
  target = @(U) logTarget (view, z, U);
  d = numel (view.unknowns.lo);
  proposal = startProposal (modes);
  sample = struct ('U', zeros (0, d), 'logP', zeros (0, 1), ...
                   'logQ', zeros (0, 0), 'count', []);
  n = settings.points;
  for stage = 1:30
    sample = extend (sample, proposal, target, n, settings.seed + 7919 * stage);
    [logW, result] = weigh (sample);
    if result.ess >= settings.effective || result.points >= settings.most
      break
    end
    proposal = moments (sample, logW, proposal.parts);
    n = min (2 * settings.points, settings.most - result.points);
  end
  result.Q = fromNormal (view.unknowns, sample.U);
  % the prior counts in full, the likelihood to the power of caution
  logPrior = -0.5 * sum (sample.U.^2, 2) - d / 2 * log (2 * pi);
  logW = logW - (1 - settings.caution) * (sample.logP - logPrior);
  logW(~isfinite (logW)) = -Inf;
  result.cautious = exp (logW - logSumExp (logW'));
end

function logP = logTarget (view, z, U)
  [M, V, success] = predictHypothesis (view, U);
  logP = logLikelihood (z - M, V, view.white.nu, view.white.common) - ...
         0.5 * sum (U.^2, 2) - columns (U) / 2 * log (2 * pi) + success;
end

function proposal = startProposal (modes)
  for m = numel (modes):-1:1
    % a proposal narrower than its target has weights without bound: a fifth wider
    C = inv (modes(m).A);
    parts(m) = struct ('mean', modes(m).U, 'root', ...
                       chol (1.2 * (C + C') / 2, 'lower'), ...
                       'share', 1 / numel (modes));
  end
  proposal = struct ('parts', parts);
end

% Every proposal ever used counts at every point.
function sample = extend (sample, proposal, target, n, seed)
  parts = proposal.parts;
  d = columns (sample.U);
  base = integrationPoints (n, d, seed);
  % a tenth from the prior bounds the weights wherever the rest has no mass (defensive
  % mixture, Hesterberg 1995, Technometrics 37)
  edges = [0, round(cumsum ([0.1, 0.9 * [parts.share]]) * n)];
  edges(end) = n;
  U = base.normal;
  for m = 1:numel (parts)
    at = edges(m + 1) + 1:edges(m + 2);
    U(at, :) = parts(m).mean + ...
               (base.normal(at, :) ./ base.root(at)) * parts(m).root';
  end
  sample.parts{numel (sample.count) + 1} = parts;
  old = zeros (rows (sample.U), 1);
  if ~isempty (old)
    old = proposalDensity (parts, sample.U);
  end
  new = zeros (n, numel (sample.count) + 1);
  for s = 1:columns (new)
    new(:, s) = proposalDensity (sample.parts{s}, U);
  end
  sample.logQ = [[sample.logQ, old]; new];
  sample.U = [sample.U; U];
  sample.logP = [sample.logP; target(U)];
  sample.count(end + 1) = n;
end

% Log density L (n x 1) of a proposal, 0.9 of a mixture of Student densities (7
% degrees of freedom, as integrationPoints draws) and 0.1 of the prior; EACH
% (n x m) that of its parts, without their shares.
function [L, each] = proposalDensity (parts, U)
  d = columns (U);
  each = zeros (rows (U), numel (parts));
  for m = 1:numel (parts)
    each(:, m) = studentDensity (parts(m), U);
  end
  prior = log (0.1) - 0.5 * sum (U.^2, 2) - d / 2 * log (2 * pi);
  L = logSumExp ([prior, log(0.9 * [parts.share]) + each]);
end

function L = studentDensity (part, U)
  % heavier tails than the target, for the same reason
  nu = 7;
  d = columns (U);
  distance = sum (((U - part.mean) / part.root').^2, 2);
  L = gammaln ((nu + d) / 2) - gammaln (nu / 2) - d / 2 * log (nu * pi) - ...
      sum (log (diag (part.root))) - (nu + d) / 2 * log1p (distance / nu);
end

function [logW, result] = weigh (sample)
  N = sum (sample.count);
  % balance heuristic (Veach and Guibas 1995): a point counts against all that
  % could have drawn it, so that a lucky draw of a bad proposal weighs little
  mixture = logSumExp (sample.logQ + log (sample.count / N));
  logW = sample.logP - mixture;
  total = logSumExp (logW');
  w = exp (logW - total);
  % effective number after Kish (1965)
  result = struct ('logE', total - log (N), 'ess', 1 / sum (w.^2), ...
                   'points', N, 'weight', w);
  % of a mean of independent weights, relative: the error of its logarithm
  result.error = sqrt (max (sum (w.^2) - 1 / N, 0));
end

function proposal = moments (sample, logW, old)
  d = columns (sample.U);
  % a covariance has d (d + 1) / 2 numbers: fewer points would make it singular
  w = flattened (logW, 12 * d);
  [~, near] = proposalDensity (old, sample.U);
  near = log ([old.share]) + near;
  near = exp (near - logSumExp (near));
  parts = old([]);
  for m = 1:numel (old)
    ofPart = w .* near(:, m);
    share = sum (ofPart);
    ofPart = ofPart / share;
    % fewer points than that tell no covariance: the part ends, the first never
    if 1 / sum (ofPart.^2) > 4 * d || m == 1
      middle = ofPart' * sample.U;
      D = (sample.U - middle) .* sqrt (ofPart);
      % wider again, and open in every direction
      C = 1.15 * (D' * D) + 1e-5 * eye (d);
      parts(end + 1) = struct ('mean', middle, 'root', chol (C, 'lower'), ...
                               'share', max (share, 0.05));
    end
  end
  whole = sum ([parts.share]);
  for m = 1:numel (parts)
    parts(m).share = parts(m).share / whole;
  end
  proposal = struct ('parts', parts);
end

% Weights to the power that leaves at least N effective points.
function w = flattened (logW, n)
  power_ = 1;
  for trial = 1:20
    w = exp (power_ * (logW - max (logW)));
    w = w / sum (w);
    if 1 / sum (w.^2) >= n
      return
    end
    power_ = 0.7 * power_;
  end
end

%!shared white, prior, settings, null
%! % Gaussian of standard deviation 1 / sqrt (800) in a wide box
%! white = struct ('p', 1, 'powers', [0; 1], 'coef', [0, 0; 20, 20], ...
%!                 'varPowers', 0, 'varCoef', [0, 0], 'nu', [Inf, Inf], ...
%!                 'effect', [], 'success', zeros (2, 1), 'common', ...
%!                 struct ('freedom', Inf, 'stretch', 1));
%! null = newHypothesis ('null');
%! prior = struct ('mean', 0, 'sd', Inf);
%! settings = struct ('prior', prior, 'seed', 3, 'points', 500, ...
%!                    'effective', 400, 'most', 12000, 'caution', 0.6);
%!test
%! % evidence known in closed form; error below 5 of its deviations (0.05)
%! mode = struct ('U', 0.1, 'A', 800);
%! r = integrateEvidence (white, null, [2, 2], mode, settings);
%! exact = -log (2 * pi) + 0.5 * log (2 * pi / 800) - log (2);
%! assert (r.logE, exact, 5 * r.error);
%! assert (r.error < 0.06);
%! assert (r.ess >= 400);
%! assert (r.weight' * r.Q, 0.1, 0.01);
%! spread = @(w) sqrt (w' * (r.Q - 0.1).^2);
%! assert (spread (r.cautious) / spread (r.weight), 1 / sqrt (0.6), 0.15);
%!test
%! % a wrong start (three times 1 / sqrt (800) off and ten times too narrow)
%! % walks to the mass
%! mode = struct ('U', 0.25, 'A', 80000);
%! r = integrateEvidence (white, null, [2, 2], mode, settings);
%! exact = -log (2 * pi) + 0.5 * log (2 * pi / 800) - log (2);
%! assert (r.logE, exact, 5 * r.error);
%! assert (r.ess >= 400);
%!test
%! % where it may not draw enough it says so
%! mode = struct ('U', 3, 'A', 80000);
%! settings.most = 500;
%! r = integrateEvidence (white, null, [2, 2], mode, settings);
%! assert (r.ess < 200);

% SPDX-License-Identifier: GPL-3.0-only
