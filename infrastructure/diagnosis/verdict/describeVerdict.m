% DESCRIBEVERDICT  Puts a verdict into names, probabilities and strengths.
%
% CALL: NAMED = describeVerdict (EVIDENCE, VERDICT, HYPOTHESES, PROBLEM)
%
%   EVIDENCE, VERDICT, HYPOTHESES, PROBLEM     of caseEvidence, judgeCase, makeHypotheses,
%                                   newProblem
%   NAMED   struct
%     verdict, reason, guard, lookAlike, sameKind, effects (of a group the likeliest
%       first), class, decides,
%       partners, likely (cellstr), see judgeCase
%     together    logical: the effects act together (a pair, also one whose name
%                 was withheld), else it is one of them
%     gateP       p of the gate
%     posterior   struct null, each effect, unlisted
%     said        struct posterior, oneOf: what is told of causes. Where a gap shows, given
%                 that there is one: without null, over what is left
%     oneOf       scalar, probability that one of effects acts
%     byItself    the same of each effect, of explanations without a likelier effect of
%                 the verdict: of one that only rides along next to nothing is left
%     cannotSee, siblings (cellstr), groups (cell of cellstr: effects that the
%       noise takes for one another, each pair of them)
%     strength    1 x K struct name, value, interval90 (NaN where the integral
%                 failed), range, variables, values, and says: what the interval
%                 is: 'amount' (of a named effect), 'least' (the same, at the end
%                 of its range: so much or more), 'bound' (of another effect: not
%                 more than its upper end), 'nothing' (no runs of the effect
%                 stand where it would be that strong and fit)
%     numbers     struct error (largest, of the logarithms of the evidences that
%                 matter), ess (least effective number of points)
%     hypotheses  1 x H struct members (cellstr), kind, probability, likeliest
%                 first

function named = describeVerdict (evidence, verdict, hypotheses, problem)
  names = hypotheses.names;
  if strcmp (verdict.kind, 'group')      % the likeliest first
    [~, order] = sort (-verdict.include(verdict.effects));
    verdict.effects = verdict.effects(order);
  end
  named = struct ('verdict', verdict.kind, 'reason', verdict.reason, ...
                  'guard', verdict.guard, 'lookAlike', verdict.lookAlike, ...
                  'sameKind', verdict.sameKind, ...
                  'effects', {names(verdict.effects)}, ...
                  'class', {names(verdict.class)}, ...
                  'decides', {verdict.decides}, ...
                  'partners', {names(verdict.partners)}, ...
                  'likely', {names(verdict.likely)}, 'gateP', evidence.gate.p);
  named.together = numel (verdict.effects) > 1 && ...
                   ~any (strcmp (verdict.guard, {'group', 'class', 'runs', ...
                                                 'readings'}));
  named.posterior.null = verdict.null;
  named.byItself = struct ();
  for k = 1:numel (names)
    field = matlab.lang.makeValidName (names{k});
    named.posterior.(field) = verdict.include(k);
    likelier = verdict.effects(verdict.include(verdict.effects) > verdict.include(k));
    isOwn = cellfun (@(m) any (m == k) && ~any (ismember (likelier, m)), evidence.members);
    named.byItself.(field) = sum (verdict.P(isOwn));
  end
  named.posterior.unlisted = verdict.unlisted;
  holds = cellfun (@(m) any (ismember (m, verdict.effects)), evidence.members);
  named.oneOf = sum (verdict.P(holds));
  named.said = saidOf (named);
  named.cannotSee = names(isinf (evidence.screen.smallest));
  named.siblings = [hypotheses.siblings{verdict.effects}];
  named.groups = confusedGroups (evidence.screen, hypotheses);
  named.strength = struct ('name', {}, 'value', {}, 'interval90', {}, ...
                           'range', {}, 'variables', {}, 'values', {}, ...
                           'says', {});
  for k = 1:numel (names)
    named.strength(k) = strengthOf (evidence, verdict, k, hypotheses, problem);
  end
  named.numbers = numbersOf (evidence, verdict);
  named.hypotheses = hypothesesOf (evidence, verdict, names);
end

% The gate says whether there is a gap; a list of causes that doubts it again would be
% read as a second answer.
function said = saidOf (named)
  [said.posterior, said.oneOf] = deal (named.posterior, named.oneOf);
  whole = 1 - named.posterior.null;
  if any (strcmp (named.verdict, {'no gap', 'surrogate'})) || ~(whole > 0)
    return
  end
  said.posterior = structfun (@(p) min (p / whole, 1), rmfield (said.posterior, 'null'), ...
                              'UniformOutput', false);
  said.oneOf = min (said.oneOf / whole, 1);
end

function numbers = numbersOf (evidence, verdict)
  matter = verdict.P > 0.01 & isfinite (evidence.ess);
  numbers = struct ('error', max ([evidence.error(matter), 0]), ...
                    'ess', min ([evidence.ess(matter), Inf]));
end

function list = hypothesesOf (evidence, verdict, names)
  P = verdict.P;
  % what an effect would have to turn too far for is rather something unlisted
  other = find (strcmp (evidence.kind, 'discrepancy'), 1);
  P(other) = P(other) + 1 - sum (P);
  [P, order] = sort (P, 'descend');
  members = cellfun (@(m) names(m), evidence.members(order), 'UniformOutput', false);
  list = struct ('members', members, 'kind', evidence.kind(order), ...
                 'probability', num2cell (P));
end

% From the likeliest hypothesis that holds the effect and was integrated.
function s = strengthOf (evidence, verdict, k, hypotheses, problem)
  holding = find (cellfun (@(m) any (m == k), evidence.members) & ...
                  ~cellfun (@(p) isempty (p.Q), evidence.posterior));
  [~, at] = max (verdict.P(holding));
  q = NaN (1, 3);
  says = 'nothing';
  if ~isempty (holding) && evidence.ess(holding(at)) >= hypotheses.options.leastPoints
    h = holding(at);
    posterior = evidence.posterior{h};
    column = hypotheses.white.p + find (evidence.members{h} == k);
    phi = posterior.Q(:, column);
    learned = hypotheses.white.effect(k);
    q = strengthInterval (phi, posterior.cautious, learned.range, learned.scale);
    % caution widens the interval; the middle is that of the whole likelihood
    q(1) = weightedQuantile (phi, posterior.weight, 0.5);
    theta = posterior.Q(:, 1:hypotheses.white.p);
    if any (verdict.effects == k) && strcmp (verdict.kind, 'named')
      says = 'amount';
      if evidence.atLimit(h) > hypotheses.options.gluedAt
        says = 'least';
      end
    elseif isBounded (learned, q, phi, theta, posterior.cautious)
      says = 'bound';
    end
  end
  at = find (strcmp ({problem.effects.name}, hypotheses.names{k}), 1);
  effect = problem.effects(at);
  variables = effect.variables;
  values = valuesOfStrength (effect, q');
  if effect.laboratory
    variables = {effect.name};
    values = effect.strongest * q';
  end
  s = struct ('name', hypotheses.names{k}, 'value', q(1), 'interval90', q(2:3), ...
              'range', effect.range, 'variables', {variables}, ...
              'values', values, 'says', says);
end

% What surrogates say of strengths at which the effect was never run, or at
% parameters far from those with which it would fit, bounds nothing. A run is
% near within a quarter of the range and of the box; an end of the range is no
% bound and needs none.
function is = isBounded (e, q, phi, theta, weight)
  is = true;
  if e.laboratory
    return
  end
  ends = q(2:3);
  step = diff (e.range) / 4;
  inside = find (abs (ends) < abs (e.range) - 1e-9 & ends ~= 0);
  hasResult = any (isfinite (e.Z), 2);
  for i = inside
    at = abs (phi - ends(i)) < step;
    if ~any (at)
      at = abs (phi - ends(i)) <= min (abs (phi - ends(i))) + 1e-9;
    end
    middle = weight(at)' * theta(at, :) / max (sum (weight(at)), realmin);
    isNear = abs (e.Q(:, end) - ends(i)) <= step & ...
             all (abs (e.Q(:, 1:end - 1) - middle) <= 0.5, 2) & hasResult;
    is = is && any (isNear);
  end
end

% Complete linkage: in a group each is mistaken for each at half strength.
function groups = confusedGroups (screen, hypotheses)
  K = numel (hypotheses.names);
  linked = false (K);
  for k = 1:K
    % at half strength; the chance is that of the method: Phi (-d sqrt ((1 - cos) /
    % 2))
    d = screen.size(k) / 2;
    linked(k, :) = d > 0 & screen.size > 0 & ...
                   normalTail (d * sqrt (max (1 - screen.cosine(k, :), 0) / ...
                                         2)) > hypotheses.options.confusedAt;
  end
  linked = linked & linked';
  groups = {};
  free = true (1, K);
  for k = 1:K
    members = k * free(k);
    for l = find (free & linked(k, :) & (1:K) > k) .* free(k)
      if l > 0 && all (linked(l, members))
        members(end + 1) = l;
      end
    end
    if numel (members) > 1
      groups{end + 1} = hypotheses.names(members);
      free(members) = false;
    end
  end
end

%!test
%! % linkage is complete: a chain is no group
%! hypotheses = handMadeHypotheses ();
%! hypotheses.reference = (-4:0.1:2)';
%! evidence = caseEvidence (hypotheses, fitLibrary (hypotheses, [1.5, 0.5, 3, 3]), 1);
%! problem = struct ('effects', newEffect (struct ('name', 'a', ...
%!                   'laboratory', true), 4));
%! problem.effects(2) = newEffect (struct ('name', 'b', 'laboratory', ...
%!                                         true), 4);
%! named = describeVerdict (evidence, judgeCase (evidence, hypotheses), hypotheses, problem);
%! assert (named.groups, {});
%! assert (named.strength(1).value, 0.7, 0.1);
%! assert (named.numbers.ess >= 200);
%! assert (named.hypotheses(1).members, {'a'});
%! assert (isfield (named.posterior, 'unlisted'));
%! assert (named.byItself.a, named.posterior.a, 1e-12);
%! % a gap shows: nobody is told twice, and otherwise, that there may be none
%! whole = 1 - named.posterior.null;
%! assert (! isfield (named.said.posterior, 'null'));
%! assert ([named.said.posterior.a, named.said.oneOf] * whole, ...
%!         [named.posterior.a, named.oneOf], 1e-12);
%! shut = setfield (evidence, 'gate', struct ('p', 0.5));
%! none = describeVerdict (shut, judgeCase (shut, hypotheses), hypotheses, problem);
%! assert (none.said.posterior, none.posterior);
%! assert (named.byItself.b < named.posterior.b);
%! % where no integral of an effect says anything, its strength is not known
%! assert (named.strength(1).says, 'amount');
%! assert (named.class, {'a'});
%! [evidence.posterior{2:end}] = deal (struct ('Q', [], 'weight', []));
%! named = describeVerdict (evidence, judgeCase (evidence, hypotheses), hypotheses, problem);
%! assert (isnan ([named.strength.value]));
%!test
%! % an upper end is a bound where the effect was run about as strong, at
%! % parameters with which it would fit; at the end of the range none is asked
%! hypotheses = handMadeHypotheses ();
%! hypotheses.reference = (-2:0.1:20)';
%! problem = struct ('effects', newEffect (struct ('name', 'a', ...
%!                   'laboratory', true), 4));
%! problem.effects(2) = newEffect (struct ('name', 'b', 'laboratory', ...
%!                                         true), 4);
%! [hypotheses.white.effect.laboratory] = deal (false);
%! [hypotheses.white.effect.Z] = deal (1);
%! said = cell (1, 3);
%! runs = {[0.5, 0.5], [0.5, 1], [-0.5, 0.5]};
%! for i = 1:3
%!   [hypotheses.white.effect.Q] = deal (runs{i});
%!   evidence = caseEvidence (hypotheses, fitLibrary (hypotheses, [1.5, 0.5, 0, 0]), 1);
%!   named = describeVerdict (evidence, judgeCase (evidence, hypotheses), hypotheses, problem);
%!   said{i} = named.strength(1).says;
%! end
%! assert (named.strength(1).interval90(2) < 0.75);
%! assert (said, {'bound', 'nothing', 'nothing'});

% SPDX-License-Identifier: GPL-3.0-only
