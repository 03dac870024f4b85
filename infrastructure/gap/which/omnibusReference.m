% OMNIBUSREFERENCE  Draws what the gate's statistic is where there is no gap.
%
% CALL: MODELS = omnibusReference (MODELS)
%
%   MODELS  struct of makeHypotheses; options.twins data sets are drawn from the
%           null model, parameters by their prior, and fitted like the
%           measurement
%   MODELS  the same with reference, a column
%
% Surrogates err in ways that they do not know: the drawn data scatter with
% options.surplus times the variance, see gapOptions.
%
% See also: omnibusTest, drawTwins

function models = omnibusReference (models)
  n = models.options.twins;
  twins = drawTwins (models, cell (1, n), zeros (n, 1), ...
                     models.options.seed + 500, models.options.surplus);
  fits = fitLibrary (models, twins.Y);
  models.reference = omnibusStatistic (models, fits.logE);
end

%!test
%! % the level is held: data sets without a gap of another seed alarm in 5 %
%! % (binomial, 200 draws and a reference of 400: chance of failing below 1 %)
%! models = handMadeHypotheses ();
%! models.options.surplus = 1;
%! models = omnibusReference (models);
%! twins = drawTwins (models, cell (1, 200), zeros (200, 1), 77);
%! s = omnibusStatistic (models, fitLibrary (models, twins.Y).logE);
%! p = (1 + sum (models.reference' >= s, 2)) / 401;
%! assert (mean (p < 0.05) > 0.005 && mean (p < 0.05) < 0.11);
