% DESCRIBEVERDICT  Puts a verdict into names, probabilities and strengths.
%
% CALL: NAMED = describeVerdict (W, VERDICT, MODELS, PROBLEM)
%
%   W, VERDICT, MODELS, PROBLEM   of weighCase, judgeCase, makeModels,
%                                 newGapProblem
%   NAMED   struct, see diagnoseMatrices
%
% See also: diagnoseMatrices, judgeCase

function named = describeVerdict (w, verdict, models, problem)
  names = models.names;
  named = struct ('verdict', verdict.kind, 'reason', verdict.reason, ...
                  'effects', {names(verdict.effects)}, ...
                  'likely', {names(verdict.likely)}, 'gateP', w.gate.p);
  named.posterior.null = verdict.null;
  for k = 1:numel (names)
    named.posterior.(matlab.lang.makeValidName (names{k})) = verdict.include(k);
  end
  named.posterior.unlisted = verdict.unlisted;
  named.cannotSee = names(isinf (w.screen.smallest));
  named.siblings = [models.siblings{verdict.effects}];
  named.groups = confusedGroups (w.screen, models);
  named.strength = struct ('name', {}, 'value', {}, 'interval90', {}, ...
                           'range', {}, 'variables', {}, 'values', {});
  for k = 1:numel (names)
    holding = find (cellfun (@(m) any (m == k), w.members));
    [~, at] = max (verdict.P(holding));
    named.strength(k) = strengthOf (w, holding(at), k, models, problem);
  end
  named.priorSpread = priorSpread (w, verdict, models);
  matter = verdict.P > 0.01 & ~strcmp (w.kind, 'unlisted');
  named.numbers = struct ('error', max ([w.error(matter), 0]), ...
                          'ess', min ([w.ess(matter), Inf]));
  [~, order] = sort (-verdict.P);
  named.hypotheses = struct ('members', {}, 'kind', {}, 'probability', {}, ...
                             'logEvidence', {}, 'fitP', {});
  for h = order
    named.hypotheses(end + 1) = ...
      struct ('members', {names(w.members{h})}, 'kind', w.kind{h}, ...
              'probability', verdict.P(h), 'logEvidence', w.logE(h), ...
              'fitP', w.fitP(h));
  end
end

function s = strengthOf (w, h, k, models, problem)
  posterior = w.posterior{h};
  column = models.white.p + find (w.members{h} == k);
  q = weightedQuantile (posterior.Q(:, column), posterior.weight, ...
                        [0.5, 0.05, 0.95]);
  at = find (strcmp ({problem.effects.name}, models.names{k}), 1);
  effect = problem.effects(at);
  variables = effect.variables;
  values = effectValues (effect, q');
  if effect.laboratory
    variables = {effect.name};
    values = effect.strongest * q';
  end
  s = struct ('name', models.names{k}, 'value', q(1), 'interval90', q(2:3), ...
              'range', effect.range, 'variables', {variables}, ...
              'values', values);
end

% Single linkage of effects that are mistaken for each other at prior strength.
function groups = confusedGroups (screen, models)
  K = numel (models.names);
  linked = eye (K) > 0;
  for k = 1:K
    d = screen.size(k) * min (models.white.effect(k).scale, 1);
    mistaken = confusion (screen.cosine(k, :), d) > 0.1;
    linked(k, :) = linked(k, :) | (mistaken & screen.size > 0 & d > 0);
  end
  linked = linked | linked';
  for step = 1:K
    linked = (double (linked) * double (linked)) > 0;
  end
  groups = {};
  for k = 1:K
    members = find (linked(k, :));
    if numel (members) > 1 && members(1) == k
      groups{end + 1} = models.names(members);
    end
  end
end

% A wide prior kills any effect (Lindley), so its width is varied: the samples
% of the top single are weighed anew with half and double the scale.
function spread = priorSpread (w, verdict, models)
  spread = [NaN, NaN];
  h = find (cellfun (@(m) isequal (m, verdict.top), w.members), 1);
  if isempty (h)
    return
  end
  posterior = w.posterior{h};
  phi = posterior.Q(:, end);
  e = models.white.effect(verdict.top);
  shrink = [0.5, 2];
  P = verdict.P;
  for i = 1:2
    ratio = density (phi, shrink(i) * e.scale, e.range) ./ ...
            density (phi, e.scale, e.range);
    factor = sum (posterior.weight .* ratio)^(1 / models.temperature);
    spread(i) = P(h) * factor / (1 - P(h) + P(h) * factor);
  end
end

function f = density (phi, scale, range)
  mass = normalTail (range(1) / scale) - normalTail (range(2) / scale);
  f = exp (-0.5 * (phi / scale).^2) / (scale * mass);
end
