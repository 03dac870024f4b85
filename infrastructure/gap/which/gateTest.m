% GATETEST  Tests whether there is a gap, by the evidence for any cause.
%
% CALL: GATE = gateTest (MODELS, FITS, I)
%
%   MODELS  struct of makeModels; reference as of gateReference
%   FITS    struct of fitLibrary;  I  row of the data set
%   GATE    struct
%     statistic  log evidence of all causes together (listed ones, what
%                resembles them, any misfit; by their priors) minus that of the
%                null model, by Laplace's formula
%     p          share of data sets without a gap, drawn and treated alike, that
%                reach it (1 where MODELS.reference is empty)
%     chi2, pFit lack of fit of the calibrated model alone, for comparison
%
% Where the evidence for a cause is 20 to 1 against the null model, p is below
% 0.05 by Markov's inequality: gate and probabilities cannot contradict each
% other but by the error of the surrogates.
%
% See also: gateReference, judgeCase

function gate = gateTest (models, fits, i)
  gate.statistic = gateStatistic (models, fits.logE(i, :));
  gate.chi2 = fits.calibrated.chi2(i);
  gate.pFit = chiSquareTail (gate.chi2, ...
                             max (columns (models.white.parity), 1));
  gate.p = 1;
  if ~isempty (models.reference)
    gate.p = (1 + sum (models.reference >= gate.statistic)) / ...
             (1 + numel (models.reference));
  end
end

%!test
%! models = handMadeModels ();
%! models.reference = (-2:0.5:2)';
%! quiet = gateTest (models, fitLibrary (models, [1.5, 0.5, 0, 0]), 1);
%! loud = gateTest (models, fitLibrary (models, [1.5, 0.5, 4, 4]), 1);
%! assert (quiet.p > 0.5);
%! assert (loud.p, 0.1, 1e-12);
%! assert (loud.statistic > 5);
