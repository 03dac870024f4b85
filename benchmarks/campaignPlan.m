% CAMPAIGNPLAN  Plans a campaign that shows every effect at many places.
%
% CALL: PLAN = campaignPlan (CASE, EFFECTS, COUNT)
%
%   CASE     see newCase; limits and options.seed are used
%   EFFECTS  1 x K struct of newEffect; those of the laboratory need no run
%   COUNT    struct: neutral (sets without effect), twice (how many of them get
%            a second packing), each (sets of every effect), pairs (cell of
%            1 x 2 cellstr, two effects at once), ofPair (sets of every pair);
%            optional first (only so many of the sets of each effect)
%   PLAN     struct X (n x d), phi (n x K), E (n x v), replicate (n x 1),
%            label (n x 1 cell: 'neutral', the effect, 'one+other')
%
% Maximin Latin hypercubes: one of the parameters for the neutral sets, one of
% parameters and strength for each effect, one of the parameters and both
% strengths for each pair. Strengths keep away from 0: they lie in 0.15 to 1, or
% with either sign. The single effects come last and alternate, so a campaign
% that is stopped early has fewer sets of all of them.
%
% Errors: DEcalioc:campaignPlan:unknownName
%
% See also: campaign, GenerateExperPlan, valuesOfStrength

function plan = campaignPlan (Case, effects, count)
  K = numel (effects);
  seed = 100 * Case.options.seed;
  X = GenerateExperPlan (Case.limits, count.neutral, '', seed);
  again = round (linspace (1, count.neutral, count.twice));
  n = count.neutral + count.twice;
  plan.X = [X; X(again, :)];
  plan.phi = zeros (n, K);
  plan.replicate = [ones(count.neutral, 1); 2 * ones(count.twice, 1)];
  plan.label = repmat ({'neutral'}, n, 1);
  parts = {};
  for i = 1:numel (count.pairs)
    parts{i} = partOf (Case, effects, numbersOf (count.pairs{i}, effects), ...
                       count.ofPair, seed + K + i);
  end
  plan = alternate (plan, parts);
  parts = {};
  for k = find (~[effects.laboratory])
    part = partOf (Case, effects, k, count.each, seed + k);
    if isfield (count, 'first')
      part = structfun (@(v) v(1:count.first, :), part, ...
                        'UniformOutput', false);
    end
    parts{end + 1} = part;
  end
  plan = alternate (plan, parts);
  plan.E = valuesOfStrength (effects, plan.phi);
end

function which = numbersOf (names, effects)
  [found, which] = ismember (names, {effects.name});
  if ~all (found)
    error ('DEcalioc:campaignPlan:unknownName', ...
           ['campaignPlan: COUNT.pairs must name effects of the case (%s), ' ...
            'got %s.'], strjoin ({effects.name}, ', '), names{find(~found, 1)});
  end
end

function part = partOf (Case, effects, which, n, seed)
  d = columns (Case.limits);
  box = [Case.limits, repmat([0; 1], 1, numel (which))];
  sample = GenerateExperPlan (box, n, '', seed);
  part.X = sample(:, 1:d);
  part.phi = zeros (n, numel (effects));
  for i = 1:numel (which)
    part.phi(:, which(i)) = strengthOf (sample(:, d + i), ...
                                        effects(which(i)).range);
  end
  part.label = repmat ({strjoin({effects(which).name}, '+')}, n, 1);
end

function phi = strengthOf (u, range)
  phi = 0.15 + 0.85 * u;
  if range(1) < 0
    s = 2 * u - 1;
    phi = sign (s) .* (0.15 + 0.85 * abs (s));
  end
end

function plan = alternate (plan, parts)
  for i = 1:max ([0, cellfun(@(p) rows (p.X), parts)])
    for part = [parts{:}]
      plan.X(end + 1, :) = part.X(i, :);
      plan.phi(end + 1, :) = part.phi(i, :);
      plan.replicate(end + 1, 1) = 1;
      plan.label(end + 1, 1) = part.label(i);
    end
  end
end

%!shared plan, Case, effects, count
%! pkg load stk
%! Case = struct ('limits', [0, 10; 1, 20], 'options', struct ('seed', 1));
%! given = {struct('name', 'a', 'variables', {{'u'}}, 'neutral', 0, ...
%!                 'limits', [0; 5]), ...
%!          struct('name', 'b', 'variables', {{'w'}}, 'neutral', 1, ...
%!                 'limits', [0.8; 1.4]), ...
%!          struct('name', 'c', 'laboratory', true)};
%! effects = cellfun (@(g) newEffect (g, 2), given);
%! count = struct ('neutral', 9, 'twice', 3, 'each', 6, ...
%!                 'pairs', {{{'b', 'a'}}}, 'ofPair', 4);
%! plan = campaignPlan (Case, effects, count);
%!test
%! assert (rows (plan.X), 9 + 3 + 2 * 6 + 4);
%! [names, ~, at] = unique (plan.label);
%! assert (names(:)', {'a', 'b', 'b+a', 'neutral'});
%! assert (accumarray (at(:), 1)', [6, 6, 4, 12]);
%! assert (plan.label(17:20)', {'a', 'b', 'a', 'b'});
%!test
%! % a second packing of a set that is there, other sets once
%! assert (sum (plan.replicate == 2), 3);
%! assert (ismember (plan.X(10:12, :), plan.X(1:9, :), 'rows'));
%! assert (rows (unique ([plan.X, plan.E], 'rows')), rows (plan.X) - 3);
%!test
%! % strengths: off, or away from zero; both signs where the effect has them
%! own = plan.phi(:, 1:2);
%! on = own(own ~= 0);
%! assert (all (abs (on) >= 0.15 & abs (on) <= 1));
%! assert (all (own(:, 1) >= 0));
%! assert (any (own(:, 2) < -0.5) && any (own(:, 2) > 0.5));
%! assert (plan.phi(:, 3), zeros (28, 1));
%! assert (sum (plan.phi ~= 0, 2), [zeros(12, 1); 2*ones(4, 1); ones(12, 1)]);
%! assert (all (plan.E(:, 2) >= 0.8 & plan.E(:, 2) <= 1.4));
%! assert (plan.E(1:12, :), repmat ([0, 1], 12, 1));
%!test
%! assert (isequal (campaignPlan (Case, effects, count), plan));
%!test
%! % a shorter campaign makes the same runs, fewer of them
%! count.first = 2;
%! short = campaignPlan (Case, effects, count);
%! assert (short.X, plan.X(1:20, :));
%! assert (short.E, plan.E(1:20, :));
%! assert (short.label, plan.label(1:20));
%!error id=DEcalioc:campaignPlan:unknownName
%! count.pairs = {{'a', 'nope'}};
%! campaignPlan (Case, effects, count);

% SPDX-License-Identifier: GPL-3.0-only
