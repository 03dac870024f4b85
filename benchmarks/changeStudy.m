% CHANGESTUDY  Diagnoses changes from a reference of which the model lacks much.
%
% CALL: octave-cli benchmarks/changeStudy.m FROM TO [CSV]
%
% FROM, TO  numbers of the cases
%
% Collapse, shear cell and heap of examples/hiddenEffect. Each case has two runs
% of LIGGGHTS of one parameter set: one without an effect (results/
% changePairs.csv; the reference) and one that storedRuns.csv holds and that is
% left out of the runs of the diagnosis: with one effect, or in three cases of
% ten without one, another packing (nothing has changed). Reading errors of
% optim.targetStd are added to both. What the model lacks in both is planted,
% otherwise than takeReference thinks: each bench has a scale of its own
% (normal), which multiplies what it gives, and clumps of two spheres move
% all results by what the runs of clumpAspect say. It is scaled so that what
% parameters cannot take of it has the size 0, 4 or 8 standard deviations. Each
% case is diagnosed with the reference and without it.
%
% One CSV row a case and way: case, reference (1, 0), lack (0, 4, 8), truth,
% phi, d (what of the change parameters cannot take, in sd), verdict,
% effects, p, probability of the truth and what resembles it, closure.
%
% See also: leftOut, takeReference

1;

function c = drawCase (number, data, pairs, phi)
  rand ('twister', 7000 + number);
  randn ('twister', 7000 + number);
  isOn = any (phi ~= 0, 2);
  hasPair = ismember (data.X, pairs.X, 'rows');
  whole = all (isfinite (data.Z), 2);
  isNull = rand () < 0.3;
  from = find (hasPair & whole & isOn ~= isNull & ~(isNull & isOn));
  c.row = from(randi (numel (from)));
  c.pair = find (ismember (pairs.X, data.X(c.row, :), 'rows'), 1);
  c.lack = 4 * randi ([0, 2]);
  c.noise = randn (2, columns (data.Z));
  c.draw = randn (1, 3);
end

% What clumps and scales of the benches add, with the size LACK.
function [offset, factor] = planted (c, z, moves, sd, bench)
  factor = c.draw(bench) / 10;
  shift = moves.clumps + z .* factor;
  left = unabsorbed (shift ./ sd, moves.slopes);
  offset = c.lack / left * moves.clumps;
  factor = 1 + c.lack / left * factor;
end

% Length of what no move of the parameters makes.
function d = unabsorbed (shift, slopes)
  d = norm (shift - (shift / slopes) * slopes);
end

% Effect of clumps, and slopes of the results along the parameters (p x T, in
% standard deviations), by least squares.
function moves = movesOf (data, phi, names, sd)
  plain = all (phi == 0, 2) & all (isfinite (data.Z), 2);
  B = [ones(sum (plain), 1), data.X(plain, :)];
  coef = B \ data.Z(plain, :);
  own = phi(:, strcmp (names, 'shape')) > 0 & all (isfinite (data.Z), 2);
  left = data.Z(own, :) - [ones(sum (own), 1), data.X(own, :)] * coef;
  moves = struct ('clumps', mean (left, 1), 'slopes', coef(2:end, :) ./ sd);
end

% Variance of a run, from the sets without an effect that were run twice.
function variance = packingOf (data, pairs, phi)
  plain = find (all (phi == 0, 2));
  [isThere, at] = ismember (data.X(plain, :), pairs.X, 'rows');
  difference = data.Z(plain(isThere), :) - pairs.Z(at(isThere), :);
  variance = mean (difference.^2, 1) / 2;
end

here = fileparts (mfilename ('fullpath'));
addpath (here);
root = startBenchmarks ();
[given, data] = storedCampaign ('hiddenEffect', root);
given.held(:) = false;
given = newProblem (given);
before = cd (fullfile (root, 'examples', 'hiddenEffect'));
Case = withEffects (loadCase (root, pwd ()));
pairs = importRuns (fullfile (here, 'results', 'changePairs.csv'), Case);
cd (before);
phi = strengthOfValues (given.effects, data.E);
sd = sqrt (given.sd.^2 + packingOf (data, pairs, phi));
names = {given.effects.name};
moves = movesOf (data, phi, names, sd);
words = argv ();
out = stdout;
if numel (words) > 2
  out = fopen (words{3}, 'w');
end
fprintf (out, ['case,reference,lack,truth,phi,d,verdict,effects,p,pTrue,' ...
               'closure\n']);
for number = str2double (words{1}):str2double (words{2})
  c = drawCase (number, data, pairs, phi);
  z = [pairs.Z(c.pair, :); data.Z(c.row, :)];
  [offset, factor] = planted (c, z(1, :), moves, sd, given.bench);
  moved = (z(2, :) - z(1, :)) ./ sd / sqrt (2);
  d = unabsorbed (moved, moves.slopes);
  y = (z + offset) .* factor + given.sd .* c.noise;
  same = all (data.X == data.X(c.row, :), 2) & ...
         all (data.E == data.E(c.row, :), 2);
  runs = keepRows (data, ~same);
  at = find (phi(c.row, :));
  truth = 'none';
  strength = 0;
  if ~isempty (at)
    truth = names{at};
    strength = phi(c.row, at);
  end
  for withReference = [1, 0]
    own = given;
    own.value = y(2, :);
    if withReference
      own.reference = struct ('value', y(1, :), 'sd', given.sd, 'trials', ...
                              given.trials, 'scatter', given.scatter, ...
                              'perCondition', false (1, columns (data.X)));
    end
    diagnosis = diagnoseMatrices (own, runs, struct ('bootstrap', 199));
    which = diagnosis.which;
    p = which.posterior.null;
    if ~isempty (at)
      p = which.posterior.(truth);
    end
    closure = NaN;
    if ~isempty (diagnosis.howFar)
      closure = diagnosis.howFar.closure;
    end
    fprintf (out, '%d,%d,%d,%s,%.3f,%.1f,%s,%s,%.4f,%.3f,%.2f\n', number, ...
             withReference, c.lack, truth, strength, d, which.verdict, ...
             strjoin (which.effects, ' '), which.gateP, p, closure);
    fflush (out);
  end
end
