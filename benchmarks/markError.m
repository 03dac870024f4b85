% MARKERROR  Is an effect known as badly where it was run as the surrogates say?
%
% CALL: octave-cli benchmarks/markError.m NUMBERS CSV
%
%   NUMBERS  foreign laboratories (foreignLab, blind), e.g. 1:24, one effect
%            each
%   CSV      table, written anew: laboratory, effect; claimed, baseline:
%            variance that is the surrogates' in all, and without the effect,
%            in units of all other noise; ratio, baselineRatio: squared error
%            by the laws over that variance
%
% As late in a diagnosis: a neutral plan over the box, and nine runs of an
% effect around one set, one at full strength, the others at 0.3 to 0.9. Looked
% at is that set at a strength of 0.6, in whitened coordinates, mean over these.
% A ratio of 1 is right; below it a diagnosis is less sure than it could be.
%
% See also: whitenEmulator, learnEffect, foreignLab

1;

function studyError (numbers, file)
  addpath (fileparts (mfilename ('fullpath')));
  startBenchmarks ();
  pkg ('load', 'stk');
  table = zeros (0, 4);
  lines = {'laboratory,effect,claimed,baseline,ratio,baselineRatio'};
  for number = numbers
    [text, table(end + 1, :)] = oneLaboratory (number);
    lines{end + 1} = text;
    disp (text);
  end
  writeAtomic (file, sprintf ('%s\n', lines{:}));
  printf (['median: claimed %.2f, baseline %.2f, ratio %.2f, ', ...
           'baselineRatio %.2f\n'], ...
          median (table, 1));
end

function [text, row] = oneLaboratory (number)
  lab = foreignLab ('blind', number);
  rand ('twister', 900000 + number);
  randn ('twister', 900000 + number);
  given = lab.gapProblem;
  dem = find (~[given.effects.laboratory]);
  k = dem(randi (numel (dem)));
  p = columns (given.limits);
  theta = 0.2 + 0.6 * rand (1, p);
  phi = 0.6 * ((1:numel (given.effects)) == k);
  given.value = lab.measure (theta, phi);
  gapProblem = newGapProblem (given);
  data = withRuns (foreignPlan (lab, neutralSets (p), 0), gapProblem, lab, ...
                   theta, k);
  [gapProblem, white] = learnWhite (gapProblem, data);
  at = gapProblem.used;
  own = white.own;
  truth = @(phi) (lab.means (theta, phi)(gapProblem.kept(at)) ./ ...
                  gapProblem.unit(at)) * white.W';
  [M, V] = predictGap (white, k, [2 * theta - 1, phi(k)]);
  [without, base] = predictGap (white, [], 2 * theta - 1);
  row = [mean((V - own) ./ own), mean((base - own) ./ own), ...
         mean((M - truth (phi)).^2 ./ (V - own)), ...
         mean((without - truth (0 * phi)).^2 ./ (base - own))];
  text = rowText ([{lab.name, given.effects(k).name}, num2cell(row)]);
end

function data = withRuns (data, gapProblem, lab, theta, k)
  n = 9;
  near = theta + 0.2 * (rand (n, numel (theta)) - 0.5);
  near(1, :) = theta;
  phi = zeros (n, numel (gapProblem.effects));
  phi(:, k) = [1; 0.3 + 0.6 * rand(n - 1, 1)];
  limits = gapProblem.limits;
  data.X = [data.X; limits(1, :) + near .* diff(limits)];
  data.E = [data.E; valuesOfStrength(gapProblem.effects, phi)];
  data.Z = [data.Z; lab.run(near, phi)];
  data.replicate = [data.replicate; ones(n, 1)];
end

args = argv ();
studyError (str2num (args{1}), args{2});
