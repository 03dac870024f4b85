% JUDGECASE  Turns evidences into a verdict, or into an honest abstention.
%
% CALL: VERDICT = judgeCase (EVIDENCE, HYPOTHESES)
%
%   EVIDENCE  struct of caseEvidence
%   HYPOTHESES  struct of makeHypotheses
%   VERDICT  struct
%     kind      'no gap', 'named', 'group', 'none of the listed' or 'undecided'
%     effects   numbers of the effects it names (one or two, or a group)
%     class     numbers of the effects that the data do not tell from the
%               likeliest one (nameCause): of a name it alone
%     decides   cellstr, readings that decide (withoutReadings); {}: none does
%     lookAlike logical: or something that resembles them
%     sameKind  logical: several effects, one of which it is, all of one class
%     partners  numbers of effects one of which acts together with a named one
%     guard     what withheld a name: '', 'integral', 'class', 'runs', 'group',
%               'readings', 'order', 'gate'; diagnoseMatrices adds 'surrogate' and 'cure'
%     reason    text, one sentence
%     P         1 x H, probability of each hypothesis of EVIDENCE; of one with effects
%               less where it needs them to do something else than their laws say
%               (turned, see caseEvidence)
%     include   1 x K, probability that the effect takes part
%     null, unlisted (discrepancies, and what P lacks) probabilities
%     likely    1 x m, fewest effects that hold 95 % of what all have together;
%               top  scalar, the likeliest one
%
% P ~ prior * exp (log evidence). What is a gap is EVIDENCE.gate's matter; then:
% 'none of the listed' where misfits that resemble no effect are likelier than
% not; else effects are named, or a class or a group of them (nameCause). That an
% effect is another one in reality than in the library is part of its
% hypothesis (formError).

function verdict = judgeCase (evidence, hypotheses)
  verdict = judged (evidence, hypotheses);
  weak = evidence.ess < hypotheses.options.leastPoints & verdict.P > 0.01;
  if any (weak) && ~strcmp (verdict.guard, 'gate') && ...
     mayDecide (evidence, hypotheses, verdict, weak)
    verdict = openVerdict (evidence, numel (hypotheses.names));
    verdict.guard = 'integral';
    verdict.reason = sprintf (['an integral rests on %.0f effective ' ...
                               'points; raise options.most'], ...
                              min (evidence.ess(weak)));
  end
end

% The likeliest hypothesis must be integrated well; of another one it is enough
% that three errors of its logarithm, or a factor of e, make no other verdict.
function yes = mayDecide (evidence, hypotheses, verdict, weak)
  [~, best] = max (verdict.P);
  yes = weak(best) || any (evidence.ess(weak) < 1);
  far = max (3 ./ sqrt (evidence.ess(weak)), 1);
  for step = {-far, far}
    if yes
      return
    end
    moved = evidence;
    moved.logE(weak) = evidence.logE(weak) + step{1};
    other = judged (moved, hypotheses);
    yes = ~strcmp (other.kind, verdict.kind) || ...
          ~isequal (other.effects, verdict.effects);
  end
end

function verdict = judged (evidence, hypotheses)
  verdict = openVerdict (evidence, numel (hypotheses.names));
  if evidence.gate.p >= hypotheses.options.significance
    verdict.kind = 'no gap';
    verdict.guard = 'gate';
    verdict.reason = sprintf (['data without a gap give as much evidence ' ...
                               'for a cause with p = %.2f'], evidence.gate.p);
  elseif verdict.unlisted >= hypotheses.options.misfitAt
    verdict.kind = 'none of the listed';
    verdict.reason = sprintf (['there is a gap (p %s) that no listed effect ' ...
                               'explains'], saidP (evidence.gate.p));
  elseif isempty (hypotheses.names)
    verdict.reason = sprintf (['there is a gap (p %s), and no effect that has ' ...
                               'runs could explain it'], saidP (evidence.gate.p));
  else
    verdict = nameCause (verdict, evidence, hypotheses);
  end
end

% Nothing is sure: never 0.000.
function text = saidP (p)
  text = sprintf ('= %.3f', p);
  if p < 0.001
    text = '< 0.001';
  end
end

function verdict = openVerdict (evidence, K)
  logP = evidence.logPrior + evidence.logE;
  verdict = struct ('kind', 'undecided', 'effects', zeros (1, 0), ...
                    'class', zeros (1, 0), 'decides', {{}}, ...
                    'lookAlike', false, 'sameKind', false, ...
                    'partners', zeros (1, 0), 'guard', '', 'reason', ...
                    'no single cause is likely enough');
  whole = exp (logP - logSumExp (logP));
  % what would have to turn too far is rather another cause, which nobody has listed
  verdict.P = whole .* (1 - evidence.turned);
  verdict.include = zeros (1, K);
  for h = 1:numel (verdict.P)
    at = evidence.members{h};
    verdict.include(at) = verdict.include(at) + verdict.P(h);
  end
  verdict.null = verdict.P(1);
  isOther = max (evidence.turned, strcmp (evidence.kind, 'discrepancy'));
  verdict.unlisted = sum (whole .* isOther);
  [~, verdict.top] = max ([verdict.include, 0]);
  [sorted, order] = sort (-verdict.include);
  most = cumsum (-sorted);
  verdict.likely = order(1:find (most >= 0.95 * max ([most, realmin]), 1));
end

%!shared evidence, hypotheses, like
%! hypotheses = struct ('names', {{'a', 'b', 'c'}}, 'siblings', {{{}, {}, {}}});
%! hypotheses.options = gapOptions ([]);
%! evidence = struct ('logE', [0, 9, 0, 0, 0, 0]);
%! evidence.logPrior = log ([0.4, 0.15, 0.15, 0.15, 0.03, 0.12]);
%! evidence.members = {[], 1, 2, 3, [1, 2], []};
%! evidence.kind = [{'null'}, repmat({'single'}, 1, 3), {'pair', 'discrepancy'}];
%! evidence.gate.p = 0.001;
%! evidence.screen = struct ('cosine', [1, 0.99, 0; 0.99, 1, 0; 0, 0, 1], ...
%!                    'size', [10, 10, 10]);
%! [evidence.phi, evidence.atLimit, evidence.ess] = deal (0.5 * ones (6, 1), zeros (1, 6), ...
%!                                   400 * ones (1, 6));
%! evidence.turned = zeros (1, 6);
%! evidence.vague = zeros (1, 3);
%! like = @(at, logE) setfield (evidence, 'logE', setfield (evidence.logE, {at}, logE));
%!test
%! % what a change of the evidence makes of the verdict: a gate that is shut, one
%! % that is alike within 6 nats, any misfit, a collapsed integral, marks of too
%! % few runs, another one that is not alike
%! cases = {evidence, 'named', 1, ''; ...
%!          setfield(evidence, 'gate', struct ('p', 0.2)), 'no gap', [], 'gate'; ...
%!          like(3, 4), 'group', [1, 2], 'class'; ...
%!          like(3, 2.5), 'named', 1, ''; ...
%!          like(6, 12), 'none of the listed', [], ''; ...
%!          setfield(evidence, 'ess', setfield (evidence.ess, {2}, 30)), 'undecided', [], ...
%!          'integral'; ...
%!          setfield(like (4, 5), 'vague', [0, 0, 0.3]), 'group', [1, 3], ...
%!          'runs'; ...
%!          like(4, 5), 'named', 1, ''; ...
%!          like(4, 8), 'group', [1, 3], 'group'}';
%! for one = cases
%!   v = judgeCase (one{1}, hypotheses);
%!   assert ({v.kind, v.guard}, one([2, 4])');
%!   assert (isequal (v.effects, one{3}) || isempty ([v.effects, one{3}]));
%!   assert (sum (v.P), 1, 1e-12);
%!   assert (v.sameKind, strcmp (one{4}, 'class'));
%! end
%! assert (judgeCase (like (3, 4), hypotheses).class, [1, 2]);
%! assert (judgeCase (evidence, hypotheses).class, 1);
%!test
%! % a poor integral of a lesser hypothesis takes a name away where it may make
%! % another verdict: c has 0.02 of the probability of a
%! poor = @(evidence, at, ess) setfield (evidence, 'ess', setfield (evidence.ess, {at}, ess));
%! for c = {like(4, 5), 100, 'named'; like(4, 6.5), 41, 'undecided'; ...
%!          like(4, 5), 0, 'undecided'; like(4, 6.5), 400, 'named'}'
%!   at = find (c{1}.logE ~= evidence.logE);
%!   v = judgeCase (poor (c{1}, at, c{2}), hypotheses);
%!   assert (v.P(at) > 0.01);
%!   assert (v.kind, c{3});
%!   assert (strcmp (v.guard, 'integral'), strcmp (c{3}, 'undecided'));
%! end
%!test
%! % a member of its family that is not on the list may be it as well
%! v = judgeCase (evidence, setfield (hypotheses, 'siblings', {{'d'}, {}, {}}));
%! assert ({v.kind, v.lookAlike}, {'named', true});
%! assert (! isempty (strfind (v.reason, 'told from d')));
%! assert (! judgeCase (evidence, hypotheses).lookAlike);
%!test
%! % a true cause may stand at the end of its range: named, and said
%! v = judgeCase (setfield (evidence, 'atLimit', 0.9 * ones (1, 6)), hypotheses);
%! assert (v.kind, 'named');
%! assert (! isempty (strfind (v.reason, 'end of its plausible range')));
%!test
%! % one that explains the data only where it does something else than its law
%! % says is no listed cause
%! v = judgeCase (setfield (evidence, 'turned', [0, 0.9, 0, 0, 0, 0]), hypotheses);
%! assert (v.kind, 'none of the listed');
%! assert (v.include(1) < 0.15);
%!test
%! % one effect is sure, and one of the two others acts with it
%! x = like ([2, 4, 5], [5, 15, 15.5]);
%! x.members(4:5) = {[1, 2], [1, 3]};
%! x.kind(4:5) = {'pair', 'pair'};
%! x.screen.cosine = eye (3);
%! v = judgeCase (x, hypotheses);
%! assert ({v.kind, v.effects, v.partners}, {'named', 1, [2, 3]});
%!test
%! % probabilities of an effect, of what is not listed, the fewest of all
%! x = struct ('logPrior', log ([0.5, 0.4, 0.1]), 'logE', zeros (1, 3), ...
%!             'kind', {evidence.kind([1, 2, 6])}, 'members', {{[], 1, []}}, ...
%!             'gate', struct ('p', 1), 'ess', NaN, 'turned', zeros (1, 3));
%! v = judgeCase (x, setfield (hypotheses, 'names', {'a'}));
%! assert ([v.include, v.unlisted, v.likely], [0.4, 0.1, 1], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
