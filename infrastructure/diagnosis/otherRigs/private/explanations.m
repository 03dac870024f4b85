% EXPLANATIONS  What tests of other benches compare, and the sets to run.
%
% CALL: [CAUSES, SETS, NAMES] = explanations (STUDY, EVIDENCE, P, OPTIONS)
%
%   STUDY, EVIDENCE, P, OPTIONS  see tryMeasurements, gapOptions
%   CAUSES  1 x h struct, see scoreMeasurements; [] where nothing of weight is open.
%           Explanation 1 is the null model, 2 to 4 are the likeliest sets of
%           effects
%   SETS    1 x G struct, one of each explanation: mode (1 x n: parameters and
%           strengths), draws (m x n, of the posterior), number (its effects),
%           doubt (variance that comes with the surrogates over that of a
%           measurement, median over the targets, where it fits best)
%   NAMES   1 x c cell, kinds of cause (likelyKinds)
%
% See also: tryMeasurements

function [causes, sets, names] = explanations (study, evidence, P, options)
  causes = [];
  sets = setOf (study, evidence, find (strcmp (evidence.kind, 'null'), 1), options);
  [keep, P, kinds, names] = likelyKinds (evidence, P, study.hypotheses);
  if isscalar (names)
    return
  end
  group = explanationOf (evidence, keep, P);
  isShown = group <= 3;
  [group, keep, kinds] = deal (group(isShown), keep(isShown), kinds(isShown));
  P = P(isShown) / sum (P(isShown));
  causes = struct ('P', num2cell (P), 'group', num2cell (group + 1), ...
                   'kind', num2cell (kinds), 'extent', 0);
  for g = 1:max (group)
    [~, at] = max (P .* (group == g));
    sets(end + 1) = setOf (study, evidence, keep(at), options);
  end
  for i = find (~strcmp (evidence.kind(keep), 'null'))
    posterior = evidence.posterior{keep(i)};
    causes(i).extent = sqrt (posterior.weight' * posterior.Q(:, end).^2);
  end
end

% Explanation of each hypothesis: the null model (0) or one of the likely sets
% of effects.
function group = explanationOf (evidence, keep, P)
  texts = cellfun (@(m) mat2str (sort (m)), evidence.members(keep), ...
                   'UniformOutput', false);
  [~, ~, number] = unique (texts);
  weight = accumarray (number(:), P(:));
  weight(number(strcmp (evidence.kind(keep), 'null'))) = Inf;
  [~, order] = sort (-weight);
  rank(order) = (1:numel (order)) - isinf (max (weight));
  group = rank(number(:)');
end

function set = setOf (study, evidence, h, options)
  members = evidence.members{h};
  p = study.emulator.p;
  columns_ = 1:p + numel (members);
  Q = study.fits.calibrated.Q(1, :);
  if ~isempty (members)
    Q = fitEffects (study.hypotheses, study.fits, 1, members, ...
                    study.hypotheses.prior).Q;
  end
  set = struct ('mode', Q(1, columns_), 'draws', [], 'number', [], ...
                'doubt', []);
  white = study.hypotheses.white;
  n = numel (white.columns);
  noise = noiseBudget (study.problem, study.emulator).covariance;
  measured = sum ((white.W(1:n, :) * noise(white.columns, white.columns)) .* ...
                  white.W(1:n, :), 2)';
  [~, V] = predictGap (white, members, set.mode);
  set.doubt = max (median (V(1:n) ./ measured) - 1, 0);
  [~, set.number] = ismember (study.hypotheses.names(members), ...
                              {study.problem.effects.name});
  posterior = evidence.posterior{h};
  n = options.testRuns / 4;
  set.draws = repmat (set.mode, n, 1);
  if ~isempty (posterior.Q)
    u = integrationPoints (n, 1, options.seed + h).uniform;
    % draws of the posterior, by its distribution function
    at = sum (cumsum (posterior.weight)' < u, 2) + 1;
    at = min (at, rows (posterior.Q));
    set.draws = posterior.Q(at, columns_);
  end
end

%!test
%! % two effects that look alike are two explanations, beside the null model
%! pkg load stk
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0.6, 0, 0, 0, 0]);
%! study = labStudy (given, data, struct ('twins', 60));
%! study.hypotheses = gapReference (study.hypotheses);
%! evidence = caseEvidence (study.hypotheses, study.fits, 1);
%! P = judgeCase (evidence, study.hypotheses).P;
%! options = study.hypotheses.options;
%! [causes, sets, names] = explanations (study, evidence, P, options);
%! assert (sum ([causes.P]), 1, 1e-12);
%! assert (max ([causes.group]), numel (sets));
%! assert (isempty (sets(1).number));
%! assert (all (ismember ({'cohesion', 'bridge'}, names)));
%! assert (rows (sets(2).draws), options.testRuns / 4);

% SPDX-License-Identifier: GPL-3.0-only
