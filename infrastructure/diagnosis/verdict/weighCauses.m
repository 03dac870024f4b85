% WEIGHCAUSES  What a person would ask for: which cause may have made the gap.
%
% CALL: LIST = weighCauses (HYPOTHESES, SCREEN, THETA, PROBLEM)
%
%   HYPOTHESES, SCREEN  of makeHypotheses, screenEffects (of the measured values)
%   THETA           1 x p, calibrated null model, parameters in [-1, 1]
%   PROBLEM         of newProblem; causes (struct of listCauses, [] for none),
%                   effects, reference
%   LIST            1 x n struct, the likeliest first: name, label, question,
%                   probability (if there is a gap at all; they add up to one),
%                   effects (cellstr, its members that the case lists). The one
%                   of name '' is none of these. Empty without causes whose lead
%                   the case lists
%
% A cause makes several effects at once, in proportions that are known roughly:
% effect i has the strength a (share_i + spread_i e_i), e_i ~ N (0, 1), with the
% amount a from 0.15 to 1.5. No runs of its own are needed: the mark
% of a cause is the sum of the marks of its effects. In the parity space,
%   rho ~ N (a sum share_i u_i, (1 + t^2 s^2 / n) I + a^2 sum spread_i^2 u_i u_i')
% with n directions, s^2 the square of the whole mark and t the tangent of the
% angle by which the real mark is off: 0, 0.35 or 0.6 with weights 0.2, 0.5, 0.3,
% as no real cause has the form of a library. Against them stands a mark in any
% direction, twice as likely as a cause. The size of any mark, in standard
% deviations, has one prior: alike on a logarithmic scale, from 2 to 30, or to twice
% what was measured where that is more. A cause
% that several listed effects may lead (three laws of attraction) is the mean of
% these. Of a change of the same grains a cause that is usually unlikely has a
% twentieth of the prior.
%
% See also: listCauses, describeCause, judgeCase

function list = weighCauses (hypotheses, screen, theta, problem)
  list = struct ('name', {}, 'label', {}, 'question', {}, ...
                 'probability', {}, 'effects', {});
  field = struct ('white', hypotheses.white, 'theta', theta, ...
                  'N', screen.parity.N, 'rho', screen.parity.rho, 'sd', []);
  [~, V] = predictGap (hypotheses.white, [], theta);
  field.sd = sqrt (V');
  logP = [];
  for cause = problem.causes
    [logE, members] = evidenceOf (cause, field, hypotheses.names, problem);
    if isfinite (logE)
      rare = ~isempty (problem.reference) && ...
             strcmp (cause.usually, 'unlikely');
      logP(end + 1) = logE + log (0.05) * rare;
      list(end + 1) = struct ('name', cause.name, 'label', cause.label, ...
                              'question', cause.question, ...
                              'probability', NaN, ...
                              'effects', {hypotheses.names(members)});
    end
  end
  if isempty (list)
    return
  end
  % none of these counts as two causes, as an unlisted effect does
  logP(end + 1) = anyMark (field.rho) + log (2);
  list(end + 1) = struct ('name', '', 'label', 'none of these', ...
                          'question', '', 'probability', NaN, ...
                          'effects', {cell(1, 0)});
  P = num2cell (exp (logP - logSumExp (logP)));
  [list.probability] = P{:};
  [~, order] = sort (-logP);
  list = list(order);
end

% -Inf where no lead is listed. MEMBERS: numbers of the effects that count.
function [logE, members] = evidenceOf (cause, field, names, problem)
  found = arrayfun (@(m) listed (m, names, problem), cause.members, ...
                    'UniformOutput', false);
  first = cellfun (@(k) k(1:min (1, end)), found, 'UniformOutput', false);
  variants = {};
  if cause.oneOf
    for i = find (~cellfun (@isempty, first))
      variants{end + 1} = {cause.members(i), first{i}};
    end
  elseif ~isempty (found{1})
    others = [first{2:end}];
    has = [false, ~cellfun(@isempty, first(2:end))];
    for k = found{1}
      variants{end + 1} = {cause.members([1, find(has)]), [k, others]};
    end
  end
  members = unique ([found{:}]);     % also those that act in place of the first
  logE = -Inf;
  if ~isempty (variants)
    each = cellfun (@(v) evidence (field, v{:}), variants);
    logE = logSumExp (each) - log (numel (each));
  end
end

% Numbers of the effects of the case that may be this member; one of the user's
% own also by its group.
function at = listed (member, names, problem)
  [~, at] = ismember (member.effects, names);
  at = at(at > 0);
  if isempty (member.group)
    return
  end
  ofUser = setdiff (names, listEffects ());
  for e = problem.effects
    if strcmp (e.group, member.group) && any (strcmp (e.name, ofUser))
      at = unique ([at, find(strcmp (names, e.name))], 'stable');
    end
  end
end

function logE = evidence (field, members, at)
  amounts = logspace (log10 (0.15), log10 (1.5), 10);
  tangents = [0, 0.35, 0.6];
  logE = zeros (numel (amounts), 3);
  s2 = zeros (1, numel (amounts));
  for i = 1:numel (amounts)
    [m, D] = markOf (field, members, at, amounts(i));
    n = numel (m);
    s2(i) = sumsq (m) + sumsq (D(:));
    for j = 1:3
      C = (1 + tangents(j)^2 * s2(i) / n) * eye (n) + D * D';
      logE(i, j) = logNormal (field.rho - m, C);
    end
  end
  logE = logSumExp (logE + log ([0.2, 0.5, 0.3]));
  logE = overSizes (logE', sqrt (s2), field.rho);
end

% Mean of the mark, and a column for what each share leaves open.
function [m, D] = markOf (field, members, at, amount)
  m = zeros (numel (field.rho), 1);
  D = zeros (numel (m), numel (at));
  for i = 1:numel (at)
    range = field.white.effect(at(i)).range;
    phi = amount * (members(i).share + members(i).spread * [0; 1; -1]);
    phi = min (max (phi, range(1)), range(2));
    [~, ~, S] = predictGap (field.white, at(i), ...
                            [repmat(field.theta, 3, 1), phi]);
    marks = field.N' * (S ./ field.sd')';
    m = m + marks(:, 1);
    % one deviation of the share up or down: what it changes of the mark
    D(:, i) = (marks(:, 2) - marks(:, 3)) / 2;
  end
end

function logE = anyMark (rho)
  n = numel (rho);
  sizes = logspace (log10 (2), log10 (most (rho)), 30);
  each = arrayfun (@(d) logNormal (rho, (1 + d^2 / n) * eye (n)), sizes);
  logE = overSizes (each, sizes, rho);
end

% Log evidences at rising SIZES, integrated over the prior of size.
function logE = overSizes (each, sizes, rho)
  x = log (max (sizes, realmin));
  ends = [x(1) - diff(x(1:2)) / 2, (x(1:end - 1) + x(2:end)) / 2, ...
          x(end) + diff(x(end - 1:end)) / 2];
  % where a strength stands at the end of its range a mark grows no more
  share = max (diff (ends), 0) / log (most (rho) / 2);
  logE = logSumExp (each + log (share));
end

function largest = most (rho)
  largest = max (30, 2 * norm (rho));
end

function logE = logNormal (r, C)
  root = chol (C, 'lower');
  logE = -0.5 * sumsq (root \ r) - sum (log (diag (root))) - ...
         numel (r) / 2 * log (2 * pi);
end

%!function [list, hypotheses] = weigh (rho, causes, isChange)
%!  % effect a moves targets 3 and 4 by 4, b target 4 by -4; the parameter is
%!  % told by the first two
%!  hypotheses = handMadeHypotheses ();
%!  theta = 0;
%!  screen = screenEffects (hypotheses.white, theta, [0, 0, rho]);
%!  problem = struct ('causes', causes, 'reference', []);
%!  problem.effects = struct ('name', {'a', 'b'}, 'group', {'', 'own'});
%!  if isChange
%!    problem.reference = struct ('value', 1);
%!  end
%!  list = weighCauses (hypotheses, screen, theta, problem);
%!endfunction
%!function c = cause (name, members, varargin)
%!  c = describeCause (struct ('name', name, 'label', name, 'question', '?', ...
%!                             'members', {members}, varargin{:}));
%!endfunction
%!shared one, both
%! one = cause ('one', {{'a'}, '', 0.5, 0.1});
%! both = cause ('both', {{'a'}, '', 0.5, 0.1; {'x'}, 'own', 0.5, 0.1});
%!test
%! % the mark of a alone, and that of both together
%! list = weigh ([4, 4], [one, both], false);
%! assert (list(1).name, 'one');
%! assert (sum ([list.probability]), 1, 1e-12);
%! list = weigh ([4, 0], [one, both], false);
%! assert ({list(1).name, list(1).effects}, {'both', {'a', 'b'}});
%! assert (list(1).probability > 0.5);
%!test
%! % one that no cause makes; causes without a lead; none at all
%! list = weigh ([-8, 3], [one, both], false);
%! assert (list(1).name, '');
%! assert (list(1).probability > 0.9);
%! assert (isempty (weigh ([4, 4], cause ('no', {{'y'}, '', 1, 1}), false)));
%! assert (isempty (weigh ([4, 4], [], false)));
%!test
%! % a cause that is unlikely while the grains are the same; alternatives
%! rare = setfield (one, 'usually', 'unlikely');
%! rare.name = 'rare';
%! odds = @(list) list(strcmp ({list.name}, 'one')).probability / ...
%!                list(strcmp ({list.name}, 'rare')).probability;
%! assert (odds (weigh ([4, 4], [one, rare], false)), 1, 1e-9);
%! assert (odds (weigh ([4, 4], [one, rare], true)), 20, 1e-9);
%! any_ = cause ('any', {{'a'}, '', 0.5, 0.1; {'b'}, '', 0.5, 0.1}, ...
%!               'oneOf', true);
%! assert (weigh ([0, -3], [one, any_], false)(1).name, 'any');

%!test
%! % a mark far off that of any cause is none of them however large it is, and a
%! % cause that makes it stays one
%! for size_ = [30, 100, 1000]
%!   list = weigh ([-0.3, 1] * size_, [one, both], false);
%!   assert (list(1).name, '');
%! end
%!test % each effect that a cause names is one of the library, or of a group
%! for cause = listCauses ()
%!   for member = cause.members
%!     isKnown = ismember (member.effects, listEffects ());
%!     assert (any (isKnown) || ~isempty (member.group), cause.name);
%!     assert (member.spread > 0 && abs (member.share) <= 1);
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
