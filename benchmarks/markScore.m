% MARKSCORE  How well do a few runs of an effect foretell its other runs?
%
% CALL: octave-cli benchmarks/markScore.m SOURCE NUMBERS CSV
%
%   SOURCE   a stored campaign of LIGGGHTS, hiddenEffect or drumAndBins, or
%            blind or develop, of foreignLab
%   NUMBERS  draws of the runs to learn from, or laboratories, e.g. 1:12
%   CSV      table, to which a row for each number of runs is added: source,
%            runs (of each effect to learn from), tests, score (mean log density
%            of a test, without constants), bestShare, bestScore (of those 0.5^6
%            to 2^2, share of the effect's variance at which it would be
%            largest, and that score), share of all variance that is the
%            effect's (median)
%
% All neutral runs are known, and 1, 4 or 8 of each effect. Of a campaign, whose
% runs fill the box, the test is each other run of that effect alone, with its
% noise. Of a laboratory runs stand around a set, the first at full strength;
% the test is what its laws give with 0.6 of it at another set, 0.2 of the box
% away along each parameter, and the expected score of what is measured there. A
% best share below 1 says that an effect is claimed to be known less than it is;
% then it seems unlikely wherever it has few runs.
%
% See also: markError, fitEffect, learnEffect

1;

function scoreMarks (source, numbers, file)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  pkg ('load', 'stk');
  if ~isfile (file)
    appendLine (file, ['source,runs,tests,score,bestShare,bestScore,', ...
                       'effectShare']);
  end
  isCampaign = ~any (strcmp (source, {'blind', 'develop'}));
  if isCampaign
    [given, stored] = storedCampaign (source, root);
  end
  for n = [1, 4, 8]
    table = zeros (0, 1 + numel (shares ()));
    for number = numbers
      if isCampaign
        table = [table; ofCampaign(given, stored, n, number)];
      else
        table = [table; ofLaboratory(source, number, n)];
      end
    end
    score = mean (table(:, 2:end), 1);
    [most, best] = max (score);
    line = rowText ({source, n, rows(table), score(shares () == 1), ...
                     shares()(best), most, median(table(:, 1))});
    appendLine (file, line);
  end
end

function c = shares ()
  c = 2.^(-6:0.5:2);
end

% Runs of each effect to learn from, by chance; a single one is a strong one, as
% in a diagnosis.
function table = ofCampaign (given, stored, n, draw)
  rand ('twister', 500000 + draw);
  randn ('twister', 500000 + draw);
  problem = newGapProblem (given);
  phi = strengthOfValues (problem.effects, stored.E);
  on = abs (phi) > 1e-9;
  isKnown = ~any (on, 2);
  tests = zeros (0, 2);
  for k = find (~[problem.effects.laboratory])
    own = find (on(:, k) & sum (on, 2) == 1 & any (isfinite (stored.Z), 2));
    [~, order] = sort (-abs (phi(own, k)) * (n == 1) + ...
                       (1 - 0.7 * (n == 1)) * rand (numel (own), 1));
    own = own(order);
    if numel (own) > n
      isKnown(own(1:n)) = true;
      tests = [tests; own(n + 1:end), repmat(k, numel (own) - n, 1)];
    end
  end
  [problem, white] = learnWhite (problem, keepRows (stored, isKnown));
  at = problem.used;
  table = [];
  limits = problem.limits;
  for one = tests'
    z = stored.Z(one(1), problem.kept(at)) ./ problem.unit(at);
    if all (isfinite (z))
      theta = 2 * (stored.X(one(1), :) - limits(1, :)) ./ diff (limits) - 1;
      q = [theta, phi(one(1), one(2))];
      z = z * white.W';
      table(end + 1, :) = scoreOf (white, one(2), q, z, white.ofRun, 0);
    end
  end
end

function table = ofLaboratory (kind, number, n)
  lab = foreignLab (kind, number);
  rand ('twister', 700000 + number);
  randn ('twister', 700000 + number);
  given = lab.gapProblem;
  dem = find (~[given.effects.laboratory]);
  K = numel (given.effects);
  p = columns (given.limits);
  set = 0.2 + 0.6 * rand (1, p);
  other = min (max (set + 0.2 * sign (rand (1, p) - 0.5), 0.02), 0.98);
  given.value = lab.measure (set, zeros (1, K));
  problem = newGapProblem (given);
  data = foreignPlan (lab, neutralSets (p), 0);
  for k = dem
    near = set + 0.2 * (rand (n, p) - 0.5);
    near(1, :) = set;
    phi = [1; 0.3 + 0.6 * rand(n - 1, 1)] .* ((1:K) == k);
    data.X = [data.X; given.limits(1, :) + near .* diff(given.limits)];
    data.E = [data.E; valuesOfStrength(problem.effects, phi)];
    data.Z = [data.Z; lab.run(near, phi)];
    data.replicate = [data.replicate; ones(n, 1)];
  end
  [problem, white] = learnWhite (problem, data);
  at = problem.used;
  table = [];
  for k = dem
    phi = 0.6 * ((1:K) == k);
    z = lab.means (other, phi)(problem.kept(at)) ./ problem.unit(at);
    table(end + 1, :) = scoreOf (white, k, [2 * other - 1, 0.6], ...
                                 z * white.W', white.own, white.own);
  end
end

% Z has the noise NOISE, of which EXPECTED is not in it but expected.
function row = scoreOf (white, k, q, z, noise, expected)
  [M, V] = predictGap (white, k, q);
  [~, base] = predictGap (white, [], q(1:white.p));
  score = zeros (1, numel (shares ()));
  for c = shares ()
    v = base - white.own + noise + c * (V - base);
    score(shares () == c) = -0.5 * sum (((M - z).^2 + expected) ./ v + log (v));
  end
  row = [mean((V - base) ./ V), score];
end

args = argv ();
scoreMarks (args{1}, str2num (args{2}), args{3});
