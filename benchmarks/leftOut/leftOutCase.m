% LEFTOUTCASE  Leaves runs out of a campaign, each once, and diagnoses them.
%
% CALL: CASES = leftOutCase (CAMPAIGN, NUMBERS)
%
%   CAMPAIGN  struct of leftOutCampaign
%   NUMBERS   1 x n, rows of CAMPAIGN.data
%   CASES     1 x n struct: campaign, row, class ('null', 'single', 'pair'),
%             cause (cellstr), phi (strengths), d (signal to noise), verdict,
%             effects (cellstr), lookAlike, guard, top (name), pTop, pTrue,
%             pNull (probabilities: of top, of the cause or what resembles it,
%             of no gap), interval (1 x 3, of the first cause), gateP, ess,
%             seconds
%
% The measurement is the row plus normal noise of the stated uncertainty (seeded
% by the row). All rows with the same inputs are taken out of the runs.
%
% See also: leftOut

function cases = leftOutCase (campaign, numbers)
  options = gapOptions ([]);
  data = campaign.data;
  inputs = [data.X, data.E];
  for j = 1:numel (numbers)
    start = tic ();
    i = numbers(j);
    same = all (inputs == inputs(i, :), 2);
    noise = integrationPoints (1, columns (data.Z), 8000 + i).normal;
    given = campaign.given;
    given.value = data.Z(i, :) + given.sd .* noise;
    problem = newProblem (given);
    emulator = fitEmulator (problem, without (data, same), options, campaign.emulator);
    kept = [emulator.effect.laboratory] | [emulator.effect.runs] >= 3;
    emulator = withoutEffects (emulator, find (~kept));
    hypotheses = makeHypotheses (problem, emulator, options);
    hypotheses.reference = campaign.reference;
    fits = fitLibrary (hypotheses, given.value);
    evidence = caseEvidence (hypotheses, fits, 1);
    verdict = judgeCase (evidence, hypotheses);
    truth = truthOf (problem, hypotheses, data, i);
    one = describe (evidence, verdict, hypotheses, truth);
    one.campaign = campaign.name;
    one.row = i;
    one.seconds = toc (start);
    cases(j) = one;
  end
end

function data = without (data, same)
  for field = {'X', 'E', 'Z', 'replicate'}
    data.(field{1}) = data.(field{1})(~same, :);
  end
end

function truth = truthOf (problem, hypotheses, data, i)
  phi = strengthOfValues (problem.effects, data.E(i, :));
  theta = 2 * toUnit (data.X(i, :), problem.limits) - 1;
  names = {problem.effects(abs (phi) > 1e-9).name};
  [has, numbers] = ismember (names, hypotheses.names);
  truth = struct ('names', {names}, 'phi', phi(abs (phi) > 1e-9), 'd', 0);
  truth.at = numbers;
  if ~isempty (names) && all (has)
    [~, ~, S] = predictGap (hypotheses.white, numbers, [theta, truth.phi]);
    white = hypotheses.white;
    [~, V, ~, J] = predictGap (white, [], theta);
    slopes = reshape (vertcat (J{:})', numel (V), white.p) ./ sqrt (V');
    N = parityProjection (slopes, zeros (numel (V), 1)).N;
    truth.d = norm (N' * (S ./ sqrt (V))');
  end
end

function one = describe (evidence, verdict, hypotheses, truth)
  classes = {'null', 'single', 'pair'};
  one = struct ('class', classes{numel(truth.names) + 1}, ...
                'cause', {truth.names}, 'phi', truth.phi, 'd', truth.d, ...
                'verdict', verdict.kind, ...
                'effects', {hypotheses.names(verdict.effects)}, ...
                'lookAlike', verdict.lookAlike, 'guard', verdict.guard, ...
                'top', hypotheses.names{verdict.top}, ...
                'pTop', verdict.include(verdict.top), 'pTrue', 0, ...
                'pNull', verdict.null, 'interval', NaN (1, 3), ...
                'gateP', evidence.gate.p, 'ess', min (evidence.ess));
  numbers = truth.at(truth.at > 0);
  if ~isempty (numbers)
    one.pTrue = max (verdict.include(numbers));
    one.interval = strengthAlone (evidence, hypotheses, numbers(1));
  end
end

% SPDX-License-Identifier: GPL-3.0-only
