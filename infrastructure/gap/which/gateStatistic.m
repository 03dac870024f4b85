% GATESTATISTIC  Log evidence of all causes together against the null model.
%
% CALL: S = gateStatistic (MODELS, LOGE)
%
%   MODELS  struct of makeModels
%   LOGE    n x (1 + 2 K + m), as of fitLibrary
%   S       n x 1
%
% See also: gateTest, gateReference

function s = gateStatistic (models, logE)
  K = numel (models.white.effect);
  w = models.weights;
  prior = [repmat(w.single / max (K, 1), 1, K), ...
           repmat(w.sibling / max (K, 1), 1, K), ...
           w.discrepancy * [models.kinds.weight]];
  s = logSumExp (logE(:, 2:end) + log (prior / sum (prior))) - logE(:, 1);
end

%!test
%! models = handMadeModels ();
%! assert (gateStatistic (models, zeros (2, 6)), [0; 0], 1e-12);
%! assert (gateStatistic (models, [0, 9 * ones(1, 5)]), 9, 1e-12);
