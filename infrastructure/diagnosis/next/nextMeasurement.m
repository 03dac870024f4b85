% NEXTMEASUREMENT  Ranks further measurements by what they would tell about the cause.
%
% CALL: TESTS = nextMeasurement (PROBLEM, EMULATOR, EVIDENCE, P, OPTIONS)
%
%   PROBLEM     struct of newProblem
%   EMULATOR    struct of fitEmulator, the effects as in EVIDENCE
%   EVIDENCE    struct of caseEvidence (members, posterior, kind)
%   P           1 x H, probabilities of the hypotheses;  OPTIONS  see gapOptions
%   TESTS       1 x m struct, best first: test (text), targets, gain (bits about
%               which kind of cause it is), cost, gainPerCost, between (1 x 2
%               cell: kinds that it tells apart most), model (name of the
%               bench); and variable ('': as the bench stands), value, trials,
%               runs of DEM that it rests on, lines, isFirm, as of tryMeasurements
%
% Candidates: every simulated but unmeasured setting (bench and coordinate; a
% curve as a whole), every bench measured once more, and of a change the reference
% on it.
%
% A kind of cause is an effect; a pair is a kind of its own, and so is no gap at
% all (likelyKinds). The gain is the expected information about it
% (mixtureInformation; Box and Hill 1967).
%
% What a second measurement meets again, the error of the surrogate and of the
% form (newHypothesis), was in the first one too: its share of the residual
% stays, R (R + S)^-1 r, and only what is left open of it, R - R (R + S)^-1 R,
% is uncertain. Packing and reading (S) are fresh; a reading without sd is taken
% for as sure as a run. Of a change the reading of the reference is met again, too (in
% R): what is foretold from it stays as it is, until the reference is measured again.
% Either is repeated on its days: what these brought to both is no part of a change.

function tests = nextMeasurement (problem, emulator, evidence, P, options)
  [tests, isReference] = candidates (problem);
  [keep, P, kinds, names] = likelyKinds (evidence, P, ...
                                         struct ('names', {{emulator.effect.name}}, ...
                                                 'options', options));
  noise = noisesOf (problem, emulator);
  for i = 1:numel (tests)
    at = tests(i).targets;
    noise.isReference = isReference(i);
    parts = struct ('mean', {}, 'cov', {});
    for k = 1:numel (keep)
      parts(k) = predictive (problem, emulator, evidence, keep(k), at, noise);
    end
    [tests(i).gain, pair] = mixtureInformation (parts, P, kinds);
    tests(i).between = names(pair);
    tests(i).gainPerCost = tests(i).gain / tests(i).cost;
  end
  [~, order] = sort (-[tests.gainPerCost]);
  tests = tests(order);
end

% Of a new reading (fresh), of one of the reference (before), and what both meet
% again (again).
function noise = noisesOf (problem, emulator)
  noise = noiseBudget (problem, emulator);
  noise.white = whitenEmulator (emulator, problem.used, noise);
  noise.fresh = noise.covariance;
  if ~isempty (emulator.change)
    % what both owe to the same days is not seen in their difference
    days = problem.reference.together;
    noise.fresh = positivePart (emulator.change.fresh - days);
    noise.before = positivePart (emulator.change.before - days);
  end
  noise.again = positivePart (noise.covariance - noise.fresh);
end

% The nearest covariance: days may weigh differently in both.
function C = positivePart (C)
  unit = sqrt (max (abs (diag (C)), realmin));
  root = unit .* covarianceRoot (C ./ (unit * unit'));
  C = root * root';
end

function [tests, isReference] = candidates (problem)
  [tests, isReference] = deal ([], false (1, 0));
  settings = [problem.bench(:), problem.coordinate(:), ...
              problem.curve(:)];
  % a curve is measured as a whole: its places are one setting
  settings(problem.curve > 0, 2) = 0;
  settings = settings(problem.possible, :);
  for row = unique (settings, 'rows')'
    at = problem.possible(all (settings == row', 2));
    names = strjoin (problem.targetNames(at), ', ');
    if numel (at) > 3 && row(3) > 0
      names = sprintf ('%s to %s', problem.targetNames{at([1, end])});
    end
    text = sprintf ('%s: measure %s', problem.benchNames{row(1)}, names);
    tests = [tests, newTest(text, at, problem, row(1))];
  end
  for b = unique (problem.bench(problem.used))
    at = problem.used(problem.bench(problem.used) == b);
    text = ['measure ', problem.benchNames{b}, ' once more'];
    tests = [tests, newTest(text, at, problem, b)];
    if ~isempty (problem.reference)
      text = ['measure the reference on ', problem.benchNames{b}, ' once more'];
      tests = [tests, newTest(text, at, problem, b)];
      isReference(numel (tests)) = true;
    end
  end
  isReference(end + 1:numel (tests)) = false;
end

function test = newTest (text, targets, problem, bench)
  test = struct ('test', text, 'targets', targets, 'gain', 0, ...
                 'cost', problem.benchCost(bench), 'gainPerCost', 0, ...
                 'between', {{}}, 'model', problem.benchNames{bench}, ...
                 'variable', '', 'value', [], 'trials', 1, ...
                 'lines', {{}}, 'runs', 0, 'isFirm', true);
end

function part = predictive (problem, emulator, evidence, h, at, noise)
  posterior = evidence.posterior{h};
  members = evidence.members{h};
  Q = posterior.Q(:, 1:emulator.p + numel (members));
  M = predictGap (emulator, members, Q)(:, at);
  S = noise.fresh(at, at);
  % a reading of unknown sd is taken for as sure as a run
  isBare = isnan (problem.value(at)) & ~(problem.sd(at) > 0);
  S = S + diag (isBare .* emulator.noiseVar(at));
  R = diag (mean (emulator.surrogateVar(:, at), 1) + emulator.fitVar(at)) + ...
      effectError (emulator, members, posterior.weight' * Q)(at, at);
  if ~isempty (members)
    [~, ~, added] = predictGap (noise.white, members, Q);
    free = noise.white.parity;
    % what it does beyond its law, in units of the noise, over the free directions
    strange = posterior.Q(:, end).^2 .* sum ((added * free).^2, 2) / ...
              max (1, columns (free));
    R = R + (posterior.weight' * strange) * diag (diag (noise.covariance(at, at) + R));
  end
  again = noise.again(at, at);
  known = problem.value(at);
  if noise.isReference
    % the level of both conditions, of which this reading has told a share
    gain = again / (again + R + S);
    M = predictGap (emulator, [], Q(:, 1:emulator.p))(:, at) + (known - M) * gain';
    part = mixed (M, posterior.weight, again - gain * again + noise.before(at, at));
    return
  end
  R = R + again;
  left = R;
  if all (isfinite (known))
    % what surrogate and form miss was in the first measurement, too: that share stays
    gain = R / (R + S);
    M = M + (known - M) * gain';
    left = R - gain * R;
  end
  part = mixed (M, posterior.weight, left + S);
end

% Law of total variance: between the draws of the posterior, and about each.
function part = mixed (M, weight, about)
  part.mean = weight' * M;
  D = (M - part.mean) .* sqrt (weight);
  part.cov = D' * D + about;
end

%!shared options
%! options = gapOptions ([]);
%!test
%! % two causes that only the unmeasured target tells apart: nearly one bit
%! e = struct ('name', {'a', 'b'}, 'powers', [0, 1], ...
%!             'coef', {[5, 9, 1], [5, -9, 1]}, 'bend', 1, ...
%!             'misfit', zeros (1, 3), 'root', zeros (1, 0), 'ofTarget', ...
%!             zeros (0, 3), 'unbent', 0, 'strongest', 1);
%! emulator = setfield (handMadeEmulator ([0, 0, 0; 1, 0, 0]), 'effect', e);
%! problem = newProblem (struct ('value', [5, NaN, 1], ...
%!                                     'sd', ones (1, 3), ...
%!                                     'bench', [1, 2, 1], 'limits', [0; 1]));
%! evidence.members = {1, 2};
%! evidence.kind = {'single', 'single'};
%! evidence.posterior = repmat ({struct('Q', [0, 1, 0, 0], 'weight', 1)}, 1, 2);
%! tests = nextMeasurement (problem, emulator, evidence, [0.5, 0.5], options);
%! assert (tests(1).targets, 2);
%! assert (tests(1).gain, 1, 0.01);
%! assert (tests(2).gain, 0, 1e-6);
%! assert (tests(1).between, {'a', 'b'});
%! % marks that nobody knows tell nothing apart
%! vague = emulator;
%! [vague.effect.misfit] = deal ([0, 1e4, 0]);
%! assert (nextMeasurement (problem, vague, evidence, [0.5, 0.5], options)(1).gain < 0.05);
%! bare = problem;
%! bare.sd(2) = NaN;
%! vague.noiseVar(2) = 1e4;
%! vague.effect = e;
%! assert (nextMeasurement (bare, vague, evidence, [0.5, 0.5], options)(1).gain < 0.05);
%! % points of one curve are measured together
%! two = problem;
%! [two.value(3), two.coordinate] = deal (NaN, [0, 1, 2]);
%! two.bench = [1, 2, 2];
%! two.possible = [2, 3];
%! two.used = 1;
%! assert (numel (nextMeasurement (two, emulator, evidence, [0.5, 0.5], options)), 3);
%! two.curve = [0, 1, 1];
%! tests = nextMeasurement (two, emulator, evidence, [0.5, 0.5], options);
%! assert ({tests.targets}, {[2, 3], 1});
%! tests = nextMeasurement (problem, emulator, evidence, [0.5, 0.5], options);
%! evidence.kind{3} = 'discrepancy';
%! evidence.posterior{3} = struct ('Q', [], 'weight', []);
%! tests = nextMeasurement (problem, emulator, evidence, [0, 0, 1], options);
%! assert ([tests.gain], zeros (1, numel (tests)), 1e-12);
%!test
%! % two causes of other marks; less is told where both have other forms than
%! % their laws, next to nothing where surrogates err alike both times
%! e = struct ('name', {'a', 'b'}, 'powers', [0, 1], ...
%!             'coef', {[3, 3, 0], [3, 0, 3]}, 'bend', 1, ...
%!             'misfit', zeros (1, 3), 'root', zeros (1, 0), 'ofTarget', ...
%!             zeros (0, 3), 'unbent', 0, 'strongest', 1);
%! emulator = setfield (handMadeEmulator ([0, 0, 0; 1, 0, 0]), 'effect', e);
%! emulator.noiseVar(:) = 0.01;
%! given = struct ('value', [3, 3, 0], 'sd', ones (1, 3), ...
%!                 'bench', [1, 1, 1], 'limits', [0; 1]);
%! problem = newProblem (given);
%! evidence.kind = {'single', 'single'};
%! evidence.posterior = repmat ({struct('Q', [0, 1, 0, 0.6], 'weight', 1)}, 1, 2);
%! evidence.members = {1, 2};
%! fresh = nextMeasurement (problem, emulator, evidence, [0.5, 0.5], options).gain;
%! [evidence.posterior{:}] = deal (struct ('Q', [0, 1, 0, 0], 'weight', 1));
%! sure = nextMeasurement (problem, emulator, evidence, [0.5, 0.5], options).gain;
%! emulator.surrogateVar(:) = 100;
%! assert (nextMeasurement (problem, emulator, evidence, [0.5, 0.5], options).gain < 0.1 * sure);
%! assert (fresh < sure);
%!test
%! % a change by 10, foretold from a reference that is known to 5, seen by a reading
%! % as sure as 0.1: only the reference can tell whether it is one
%! e = struct ('name', 'a', 'powers', [0, 1], 'coef', 10, 'bend', 1, 'misfit', 0, ...
%!             'root', zeros (1, 0), 'ofTarget', zeros (0, 1), 'unbent', 0, ...
%!             'strongest', 1);
%! emulator = handMadeEmulator ([0; 1e-3]);
%! emulator.noiseVar(:) = 1e-6;
%! given = struct ('value', 10, 'sd', 0.1, 'trials', Inf, 'limits', [0; 1], ...
%!                 'bench', 1, 'benchNames', {{'Heap'}});
%! given.reference = struct ('value', 0, 'sd', 5, 'trials', Inf, 'scatter', false, ...
%!                           'perCondition', false);
%! problem = newProblem (given);
%! emulator.range = 1e3;
%! emulator = emulateChange (emulator, problem);
%! emulator.effect = e;
%! evidence.members = {[], 1};
%! evidence.kind = {'null', 'single'};
%! evidence.posterior = {struct('Q', [0, 0], 'weight', 1), ...
%!                       struct('Q', [0, 1, 0], 'weight', 1)};
%! tests = nextMeasurement (problem, emulator, evidence, [0.5, 0.5], options);
%! assert (tests(1).test, 'measure the reference on Heap once more');
%! assert (tests(1).gain > 0.2);
%! assert (tests(2).gain < 0.02);
%! % both of the same days, which differ more than anything else: their trials are
%! % left, and either tells a little
%! given.sd = 5;
%! given.shared = 4.99;
%! [given.reference.shared, given.reference.together] = deal (4.99, 4.99^2);
%! problem = newProblem (given);
%! emulator = emulateChange (emulator, problem);
%! tests = nextMeasurement (problem, emulator, evidence, [0.5, 0.5], options);
%! assert (all ([tests.gain] >= 0 & [tests.gain] < 1));

% SPDX-License-Identifier: GPL-3.0-only
