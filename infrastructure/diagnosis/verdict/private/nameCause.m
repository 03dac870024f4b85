% NAMECAUSE  Which effects a verdict names, where a listed one may be the cause.
%
% CALL: VERDICT = nameCause (VERDICT, EVIDENCE, HYPOTHESES)
%
%   VERDICT, EVIDENCE, HYPOTHESES  see judgeCase; of VERDICT kind, effects, class, sameKind,
%                       lookAlike, partners, guard and reason come back as they
%                       are where nothing can be named
%
% The class of an effect are those that explain the data without it, less likely
% by a factor of exp (classNats) at most, and whose marks on the targets have a
% cosine of classAt or more with its own: an error of form turns one into the
% other. A name needs a probability of nameAt, a class of one, no other effect
% with othersAt of its probability, and no other one within classNats whose mark,
% or its own, too few runs have told (vagueRun): the better emulated would win.

function verdict = nameCause (verdict, evidence, hypotheses)
  options = hypotheses.options;
  top = verdict.top;
  strong = find (verdict.include >= options.nameAt);
  if isempty (strong)
    verdict.class = unique ([top, classOf(evidence, verdict, top, hypotheses)]);
    verdict = nameGroup (verdict, evidence, hypotheses);
    return
  end
  [others, guard] = rivalsOf (evidence, verdict, strong, hypotheses);
  if ~isempty (others) && numel (strong) > 1
    % of a pair the surer half, where the other half has rivals
    strong = top;
    [others, guard] = rivalsOf (evidence, verdict, strong, hypotheses);
  end
  verdict.class = unique ([strong, classOf(evidence, verdict, strong, hypotheses)]);
  if isempty (others)
    verdict = sayCause (verdict, evidence, hypotheses, strong);
    verdict.partners = partnersOf (evidence, verdict, strong, options);
    return
  end
  verdict.kind = 'group';
  verdict.guard = guard;
  verdict.effects = unique ([strong, others]);
  verdict.sameKind = strcmp (guard, 'class');
  reasons = struct ('class', ['these targets do not tell it from what moves ' ...
                              'them in nearly the same way'], ...
                    'runs', ['too few runs have told what each does where it ' ...
                             'would explain the measurements'], ...
                    'group', 'another one is nearly as likely');
  verdict.reason = reasons.(guard);
end

% A name, and whether a member of its family is not on the list.
function verdict = sayCause (verdict, evidence, hypotheses, strong)
  missing = [hypotheses.siblings{strong}];
  verdict.kind = 'named';
  verdict.effects = strong;
  verdict.lookAlike = ~isempty (missing);
  verdict.reason = sprintf ('probability %.2f', min (verdict.include(strong)));
  if ~isempty (missing)
    verdict.reason = ['it cannot be told from ', strjoin(missing, ', '), ...
                      ', which is not listed or has no runs'];
  end
  if max (evidence.atLimit(bestWith (evidence, verdict, strong))) > hypotheses.options.gluedAt
    verdict.reason = [verdict.reason, '; it stands at the end of its ' ...
                      'plausible range, or beyond'];
  end
end

% By the data alone: what was thought of each effect beforehand (factor of
% newEffect) does not count.
function alike = classOf (evidence, verdict, strong, hypotheses)
  factor = givenField (hypotheses, 'factor', ones (size (verdict.include)));
  nats = natsBehind (evidence, verdict, strong) + log (factor) - ...
         log (min (factor(strong)));
  cosine = max (evidence.screen.cosine(strong, :), [], 1);
  alike = find (nats <= hypotheses.options.classNats & ...
                cosine >= hypotheses.options.classAt);
end

% Effects that withhold a name from STRONG, and why. An effect that is likely
% only beside them is a partner, unless the two signatures are alike and they
% stand together in half of all: a pair of look-alikes is one of them, badly
% modelled, as often as it is both, and then all hypotheses count.
function [others, guard] = rivalsOf (evidence, verdict, strong, hypotheses)
  options = hypotheses.options;
  others = classOf (evidence, verdict, strong, hypotheses);
  guard = 'class';
  if ~isempty (others)
    return
  end
  nats = natsBehind (evidence, verdict, strong);
  isVague = evidence.vague > options.vagueRun;
  others = find (nats <= options.classNats & ...
                 (isVague | any (isVague(strong))));
  guard = 'runs';
  if ~isempty (others)
    return
  end
  guard = 'group';
  least = min (verdict.include(strong));
  rival = nats < -log (options.othersAt / numel (strong));
  for k = setdiff (1:numel (rival), strong)
    together = cellfun (@(m) any (m == k) && all (ismember (strong, m)), ...
                        evidence.members);
    rival(k) = rival(k) || ...
               (max (abs (evidence.screen.cosine(k, strong))) >= options.alikeAt && ...
                sum (verdict.P(together)) >= 0.5 * least);
  end
  others = find (rival);
end

% Effects one of which acts together with the strong one, likelier than not.
function joining = partnersOf (evidence, verdict, strong, options)
  joining = zeros (1, 0);
  pairs = find (strcmp (evidence.kind, 'pair'));
  holds = pairs(cellfun (@(m) any (ismember (strong, m)), evidence.members(pairs)));
  if numel (strong) > 1 || sum (verdict.P(holds)) < 0.5 * verdict.include(strong)
    return
  end
  for h = holds(verdict.P(holds) > options.partnerAt)
    joining = [joining, setdiff(evidence.members{h}, strong)];
  end
  joining = unique (joining);
end

function best = bestWith (evidence, verdict, strong)
  holding = cellfun (@(m) all (ismember (strong, m)), evidence.members) & ...
            ~strcmp (evidence.kind, 'discrepancy');
  if ~any (holding)
    holding = cellfun (@(m) any (ismember (strong, m)), evidence.members);
  end
  [~, best] = max (verdict.P - 2 * ~holding);
end

% The class of the likeliest one, where it has groupAt together; else the fewest
% likely effects that have: two or three, or more of a long list, up to a third:
% beyond that a group says less than the probabilities of its members.
function verdict = nameGroup (verdict, evidence, hypotheses)
  [~, order] = sort (-verdict.include);
  most = min (max (3, floor (numel (order) / 3)), numel (order));
  sets = [{verdict.class}, arrayfun(@(n) order(1:n), 2:most, ...
                                    'UniformOutput', false)];
  guards = [{'class'}, repmat({'group'}, 1, most - 1)];
  for i = find (cellfun (@numel, sets) > 1)
    holding = cellfun (@(m) any (ismember (sets{i}, m)), evidence.members);
    together = sum (verdict.P(holding));
    if together >= hypotheses.options.groupAt
      verdict.kind = 'group';
      verdict.guard = guards{i};
      verdict.sameKind = strcmp (guards{i}, 'class');
      verdict.effects = sort (sets{i});
      verdict.reason = sprintf ('one of them with probability %.2f', together);
      return
    end
  end
end

%!shared evidence, verdict, hypotheses, named
%! evidence.members = {1, [1, 2], [1, 3], 2, []};
%! evidence.kind = {'single', 'pair', 'pair', 'single', 'discrepancy'};
%! evidence.screen = struct ('cosine', eye (3), 'size', [10, 10, 10]);
%! [evidence.phi, evidence.atLimit] = deal (0.5 * ones (5, 1), zeros (1, 5));
%! evidence.vague = zeros (1, 3);
%! hypotheses = struct ('names', {{'a', 'b', 'c'}}, 'siblings', {{{}, {}, {}}});
%! hypotheses.options = gapOptions ([]);
%! verdict = struct ('P', [0.3, 0.38, 0.24, 0.03, 0.05], 'include', ...
%!                   [0.92, 0.41, 0.24], 'top', 1, 'kind', 'undecided', ...
%!                   'effects', [], 'class', []);
%! named = @(evidence, verdict, hypotheses) nameCause (verdict, evidence, hypotheses).effects;
%!assert (named (evidence, verdict, hypotheses), 1)
%!test
%! sharper = setfield (hypotheses, 'options', setfield (hypotheses.options, ...
%!                                                  'othersAt', 0.03));
%! assert (named (evidence, verdict, sharper), [1, 2]);
%!test
%! % one that looks like the strong one, and stands beside it more often than
%! % not, may take its place
%! [alike, v] = deal (evidence, verdict);
%! alike.screen.cosine(2, 1) = -0.8;
%! assert (named (alike, v, hypotheses), 1);
%! v.P = [0.2, 0.48, 0.24, 0.03, 0.05];
%! assert (named (alike, v, hypotheses), [1, 2]);
%! alike.screen.cosine(2, 1) = 0.6;
%! assert (named (alike, v, hypotheses), 1);
%!test
%! % of a sure pair, a third effect takes the place of the lesser half, and
%! % needs half as much for it; without one both are named
%! v = verdict;
%! v.include = [0.99, 0.92, 0.2];
%! for third = [0.2, 0.06]
%!   v.P = [0.3, 0.55, third, 0, 0.1];
%!   assert (named (evidence, v, hypotheses), 1);
%! end
%! v.P(3) = 0.02;
%! assert (named (evidence, v, hypotheses), [1, 2]);
%!test
%! % what the data do not tell from the likeliest one is its class, however
%! % likely it is; which of the others is as likely does not matter
%! evidence.members = {1, 2, 3};
%! evidence.kind = repmat ({'single'}, 1, 3);
%! evidence.screen.cosine = [1, 0.9, 0; 0.9, 1, 0; 0, 0, 1];
%! v = verdict;
%! [v.P, v.include] = deal ([0.5, 0.35, 0.15]);
%! v = nameCause (v, evidence, hypotheses);
%! assert ({v.class, v.effects, v.sameKind, v.guard}, ...
%!         {[1, 2], [1, 2], true, 'class'});
%! [v.P, v.include] = deal ([0.6, 0.1, 0.3]);
%! v = nameCause (v, evidence, hypotheses);
%! assert ({v.class, v.effects, v.guard}, {[1, 2], [1, 3], 'group'});
%! [v.P, v.include] = deal ([0.4, 0.3, 0.05]);
%! v.kind = 'undecided';
%! assert (nameCause (v, evidence, hypotheses).kind, 'undecided');
%!test
%! % no two or three of twelve, but four, that hold 0.8; five are too many
%! evidence.members = num2cell (1:12);
%! evidence.kind = repmat ({'single'}, 1, 12);
%! evidence.screen.cosine = eye (12);
%! evidence.vague = zeros (1, 12);
%! v = setfield (verdict, 'top', 2);
%! v.P = [0.2, 0.25, 0.05, 0.2, 0.02, 0.2, 0.01 * ones(1, 6)];
%! v.include = v.P;
%! v = nameCause (v, evidence, hypotheses);
%! assert ({v.kind, v.effects, v.guard}, {'group', [1, 2, 4, 6], 'group'});
%! v.P([1, 2, 3, 4, 6]) = [0.17, 0.2, 0.15, 0.17, 0.17];
%! [v.include, v.kind] = deal (v.P, 'undecided');
%! assert (nameCause (v, evidence, hypotheses).kind, 'undecided');

% SPDX-License-Identifier: GPL-3.0-only
