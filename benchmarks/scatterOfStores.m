% SCATTEROFSTORES  How well scatter.csv of a bench foretells the scatter of a case.
%
% CALL: octave-cli benchmarks/scatterOfStores.m
%
% The noise that a surrogate finds in the stored runs without an effect, 35 and 51
% sets over the whole box, beside that of 8 packings of one set (earlierScatter),
% both as shares of the response. Prints each, and mean and deviation of the log
% ratio of the variances: noisePrior is made of it.
%
% See also: noisePrior, storedCampaign

1;

function ratio = ofStore (name, root)
  [problem, data] = storedCampaign (name, root);
  isNeutral = all (abs (strengthOfValues (problem.effects, data.E)) < 1e-9, 2);
  ratio = [];
  for t = find (isfinite (problem.earlierSd))
    isUsed = isNeutral & isfinite (data.Z(:, t));
    s = fitSurrogate (data.X(isUsed, :), data.Z(isUsed, t), problem.limits);
    found = sqrt (s.noiseVar) / abs (mean (s.z));
    known = problem.earlierSd(t) / abs (problem.value(t));
    ratio(end + 1) = 2 * log (found / known);
    printf ('%s %s: %.2f %%, foretold %.2f %%\n', name, problem.targetNames{t}, ...
            100 * found, 100 * known);
  end
end

addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
pkg ('load', 'stk');
pkg ('load', '-nodeps', 'struct', 'optim');
ratio = [ofStore('hiddenEffect', root), ofStore('drumAndBins', root)];
printf ('%d responses: log ratio of the variances %.2f, deviation %.2f\n', ...
        numel (ratio), mean (ratio), std (ratio));
