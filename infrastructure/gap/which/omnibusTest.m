% OMNIBUSTEST  Tests whether there is a gap, by the evidence for any cause.
%
% CALL: GATE = omnibusTest (MODELS, LOGE)
%
%   MODELS  struct of makeHypotheses; reference as of omnibusReference
%   LOGE    n x H, evidences of fitLibrary
%   GATE    struct, both n x 1
%     statistic  log evidence of all causes together (listed ones, what
%                resembles them, any misfit; by their priors) minus that of the
%                null model, by Laplace's formula
%     p          share of data sets without a gap, drawn and treated alike, that
%                reach it (1 where MODELS.reference is empty)
%
% Where the evidence for a cause is 20 to 1 against the null model, p is below
% 0.05 by Markov's inequality: gate and probabilities cannot contradict each
% other but by the error of the surrogates.

function gate = omnibusTest (models, logE)
  prior = [models.list.prior];
  share = log (prior(2:end) / sum (prior(2:end)));
  gate.statistic = logSumExp (logE(:, 2:end) + share) - logE(:, 1);
  gate.p = ones (rows (logE), 1);
  if ~isempty (models.reference)
    gate.p = (1 + sum (models.reference' >= gate.statistic, 2)) / ...
             (1 + numel (models.reference));
  end
end

%!test
%! models = handMadeHypotheses ();
%! models.reference = (-2:0.5:2)';
%! fits = fitLibrary (models, [1.5, 0.5, 0, 0; 1.5, 0.5, 4, 4]);
%! gate = omnibusTest (models, fits.logE);
%! assert (gate.p(1) > 0.5);
%! assert (gate.p(2), 0.1, 1e-12);
%! assert (gate.statistic(2) > 5);
%! gate = omnibusTest (models, [zeros(1, 6); 0, 9 * ones(1, 5)]);
%! assert (gate.statistic, [0; 9], 1e-12);
