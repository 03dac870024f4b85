% INTERVALCAUTION  How sure may the interval of a strength be?
%
% CALL: octave-cli benchmarks/intervalCaution.m [LABORATORIES] [CASES]
%
%   LABORATORIES  of foreign laws, kind develop, e.g. 1:8 (default)
%   CASES         single causes of each (36)
%
% For several powers of the likelihood (options.caution of gapOptions): the
% share of 90 % intervals that hold the strength, and their median width in
% shares of the range. Only the true effect is fitted and integrated, so a case
% takes a tenth of a second; verdicts have no part in it.
%
% See also: strengthInterval, foreignTwins

1;

function list = ofLaboratory (number, perLab, cautions)
  lab = foreignLab ('develop', number);
  rand ('twister', 777000 + number);
  randn ('twister', 777000 + number);
  lab.data = lab.plan (40, 20);
  given = setfield (lab.gapProblem, 'value', mean (lab.data.Z));
  problem = newGapProblem (given);
  options = gapOptions ([]);
  em = fitEmulator (problem, lab.data, options);
  lab.noise = sqrt (given.sd.^2 + lab.noiseSd.^2 + mean (em.surrogateVar, 1));
  mix = twinsMix ('foreign develop singles');
  mix.seed = 777000 + number;
  twins = twinsDraw (lab, perLab, mix);
  models = makeHypotheses (problem, em, options);
  models.list = models.list([1, models.singles]);
  fits = fitLibrary (models, vertcat (twins.y)(:, models.white.columns));
  list = [];
  for i = 1:numel (twins)
    k = twins(i).cause;
    ends = arrayfun (@(c) intervalOf (models, fits.of{1 + k}, i, k, c), ...
                     cautions, 'UniformOutput', false);
    ends = vertcat (ends{:})';
    phi = twins(i).phi(k);
    list(end + 1, :, :) = [phi >= ends(1, :) & phi <= ends(2, :); ...
                           diff(ends) / diff(models.white.effect(k).range)];
  end
end

% Ends of the interval of effect K from data set I.
function ends = intervalOf (models, fit, i, k, caution)
  row = models.list(1 + k);
  settings = setfield (models.options, 'caution', caution);
  settings.prior = models.prior;
  modes = struct ('U', fit.U(i, :), 'A', squeeze (fit.A(i, :, :)));
  if fit.hasOther(i)
    modes(2) = struct ('U', fit.other.U(i, :), ...
                       'A', squeeze (fit.other.A(i, :, :)));
  end
  r = integrateEvidence (row.white, row.h, fit.Z(i, :), modes, settings);
  effect = models.white.effect(k);
  ends = strengthInterval (r.Q(:, models.white.p + 1), r.cautious, ...
                           effect.range, effect.scale)(2:3);
end

args = argv ();
defaults = {'1:8', '36'};
args(end + 1:2) = defaults(numel (args) + 1:2);
addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
pkg ('load', 'stk');
cautions = [1, 0.8, 0.6, 0.5, 0.4, 0.3];
found = [];
for number = str2num (args{1})
  found = [found; ofLaboratory(number, str2double (args{2}), cautions)];
end
for c = 1:numel (cautions)
  holds = found(:, 1, c);
  [lo, hi] = binomialInterval (sum (holds), numel (holds));
  printf ('power %.1f: %d / %d = %.0f %% (%.0f - %.0f), width %.2f\n', ...
          cautions(c), sum (holds), numel (holds), 100 * mean (holds), ...
          100 * lo, 100 * hi, median (found(:, 2, c)));
end
