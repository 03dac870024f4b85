% GAPTEST  Tests whether there is a gap, by the evidence for any cause.
%
% CALL: GATE = gapTest (HYPOTHESES, LOGE)
%
%   HYPOTHESES  struct of makeHypotheses; reference as of gapReference
%   LOGE    n x H, evidences of fitLibrary
%   GATE    struct, n x 1 each
%     statistic  log evidence of all causes together (effects, any misfit; by
%                their priors) minus that of the null model
%     p          share of HYPOTHESES.reference, data sets without a gap, that reach
%                it (1 where HYPOTHESES.reference is empty); what is less than a
%                fiftieth by their tail, see below; of a change at least what the
%                readings alone leave (HYPOTHESES.alone, see readingsAlone)
%
% Where the evidence for a cause is 20 to 1 against the null model, p is below
% 0.05 by Markov's inequality: gate and probabilities cannot contradict each
% other but by the error of the surrogates.
%
% The tail: generalised Pareto beyond the largest tenth (20 at least) by
% probability-weighted moments (Hosking and Wallis 1987), not lighter than
% exponential.

function gate = gapTest (hypotheses, logE)
  prior = [hypotheses.list.prior];
  share = log (prior(2:end) / sum (prior(2:end)));
  % discrepancies are among them: a gap that no effect explains is one as well
  gate.statistic = logSumExp (logE(:, 2:end) + share) - logE(:, 1);
  gate.p = ones (rows (logE), 1);
  if ~isempty (hypotheses.reference)
    n = numel (hypotheses.reference);
    gate.p = (1 + sum (hypotheses.reference' >= gate.statistic, 2)) / (1 + n);
    % below a fiftieth the count of a few twins is too coarse
    far = gate.p < 0.02 & n >= 40;
    if any (far)
      gate.p(far) = min (gate.p(far), ...
                         tailOf (hypotheses.reference, gate.statistic(far)));
    end
  end
  if isfield (hypotheses, 'alone')
    gate.p = max (gate.p * ~hypotheses.alone.decides, hypotheses.alone.p);
  end
  gate.p = max (gate.p, eps (1));        % nothing is sure
end

function p = tailOf (reference, x)
  n = numel (reference);
  m = max (20, round (n / 10));
  sorted = sort (reference);
  from = mean (sorted(n - m:n - m + 1));
  beyond = sorted(n - m + 1:n) - from;
  % first two probability-weighted moments
  b0 = mean (beyond);
  b1 = ((m - 1:-1:0) / (m - 1)) * beyond / m;
  % a negative shape would end the tail and make a p of 0
  shape = max (2 - b0 / (b0 - 2 * b1), 0);
  scale = b0 * (1 - shape);
  z = (x - from) / scale;
  p = m / n * exp (-z);
  if shape > 1e-6
    p = m / n * (1 + shape * z).^(-1 / shape);
  end
end

%!test
%! hypotheses = handMadeHypotheses ();
%! hypotheses.reference = (-2:0.5:2)';
%! fits = fitLibrary (hypotheses, [1.5, 0.5, 0, 0; 1.5, 0.5, 4, 4]);
%! gate = gapTest (hypotheses, fits.logE);
%! assert (gate.p(1) > 0.5);
%! assert (gate.p(2), 0.1, 1e-12);   % nine draws tell no tail
%! assert (gate.statistic(2) > 5);
%! gate = gapTest (hypotheses, [zeros(1, 4); 0, 9 * ones(1, 3)]);
%! assert (gate.statistic, [0; 9], 1e-12);
%!test
%! % p of an exponential tail beyond what was drawn: within a factor of three
%! % for 400 draws (seeded)
%! hypotheses = handMadeHypotheses ();
%! rand ('twister', 3);
%! hypotheses.reference = -log (rand (400, 1));
%! logE = zeros (2, 4);
%! gate = gapTest (hypotheses, [[0; 0], [8; 10] * ones(1, 3)]);
%! assert (log (gate.p), [-8; -10], log (3));
%! assert (gapTest (hypotheses, logE).p, [1; 1], 0.01);

% SPDX-License-Identifier: GPL-3.0-only
