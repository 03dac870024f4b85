% JUDGECASE  Turns evidences into a verdict, or into an honest abstention.
%
% CALL: VERDICT = judgeCase (W, MODELS)
%
%   W        struct of caseEvidence
%   MODELS   struct of makeHypotheses
%   VERDICT  struct
%     kind      'no gap', 'named', 'group', 'none of the listed' or 'undecided'
%     effects   numbers of the effects it names (one or two, or a group)
%     lookAlike logical: or something that resembles them; of a name: these
%               targets do not tell whether it is this very effect
%     sameKind  logical: several effects, one of which it is, and whose marks on
%               the targets are nearly the same (cosine 0.9): which one it is,
%               these targets do not tell
%     partners  numbers of effects one of which acts together with a named one
%     guard     what withheld a name: '', 'integral', 'look-alike', 'group',
%               'gate'; diagnoseMatrices adds 'surrogate' and 'cure'
%     reason    text, one sentence
%     P         1 x H, probability of each hypothesis of W
%     include   1 x K, probability that the effect takes part
%     resemble  1 x K, that something not listed which resembles it does
%     alike     1 x K, that it is this effect, alone or with another one, or a
%               cause whose mark on the targets is nearly the same (W.alike)
%     null, unlisted (siblings and discrepancies) probabilities
%     likely    1 x m, fewest effects (by include + resemble) that hold 95 % of
%               what all have together;  top  scalar, the likeliest one
%
% P ~ prior * exp (log evidence). What is a gap is W.gate's matter; then:
% 'none of the listed' where misfits that resemble no effect, or that resemble
% one without being it, are likelier than not; a name where alike of one effect
% (or of two) reaches nameAt and no other explains the data without it with a
% tenth of that; a group where that is not so but effects, or what resembles
% them, have groupAt together. What kind of cause it is and whether it is this
% very one are two claims: the second needs data that exclude a look-alike of
% cosine 0.9, which a perfect model passes half of the time only from d = 6 on.

function verdict = judgeCase (w, models)
  verdict = judged (w, models);
  weak = w.ess < models.options.leastPoints & verdict.P > 0.01;
  if any (weak) && ~strcmp (verdict.guard, 'gate') && ...
     mayDecide (w, models, verdict, weak)
    verdict = openVerdict (w, numel (models.names));
    verdict.guard = 'integral';
    verdict.reason = sprintf (['an integral rests on %.0f effective ' ...
                               'points; raise options.most'], ...
                              min (w.ess(weak)));
  end
end

% The likeliest hypothesis must be integrated well; of another one it is enough
% that three errors of its logarithm, or a factor of e, make no other verdict.
function yes = mayDecide (w, models, verdict, weak)
  [~, best] = max (verdict.P);
  yes = weak(best) || any (w.ess(weak) < 1);
  far = max (3 ./ sqrt (w.ess(weak)), 1);
  for step = {-far, far}
    if yes
      return
    end
    moved = w;
    moved.logE(weak) = w.logE(weak) + step{1};
    other = judged (moved, models);
    yes = ~strcmp (other.kind, verdict.kind) || ...
          ~isequal (other.effects, verdict.effects);
  end
end

function verdict = judged (w, models)
  verdict = openVerdict (w, numel (models.names));
  if w.gate.p >= models.options.level
    verdict.kind = 'no gap';
    verdict.guard = 'gate';
    verdict.reason = sprintf (['data without a gap give as much evidence ' ...
                               'for a cause with p = %.2f'], w.gate.p);
  elseif verdict.misfit >= models.options.misfitAt
    verdict.kind = 'none of the listed';
    verdict.reason = sprintf (['there is a gap (p = %.3f) that no listed ' ...
                               'effect explains'], w.gate.p);
  elseif isempty (models.names)
    verdict.reason = sprintf (['there is a gap (p = %.3f), and no effect ' ...
                               'that has runs could explain it'], w.gate.p);
  else
    verdict = nameCause (verdict, w, models);
    verdict.sameKind = isOneKind (w, verdict, models.options);
  end
end

function is = isOneKind (w, verdict, options)
  cosine = w.screen.cosine(verdict.effects, verdict.effects);
  is = strcmp (verdict.guard, 'group') && ...
       all (abs (cosine(:)) >= cos (atan (options.lookAlike(1))));
end

function verdict = openVerdict (w, K)
  logP = w.logPrior + w.logE;
  verdict = struct ('kind', 'undecided', 'effects', zeros (1, 0), ...
                    'lookAlike', false, 'sameKind', false, ...
                    'partners', zeros (1, 0), 'guard', '', 'reason', ...
                    'no single cause is likely enough');
  verdict.P = exp (logP - logSumExp (logP));
  [verdict.include, verdict.resemble, verdict.alike] = deal (zeros (1, K));
  for h = 1:numel (verdict.P)
    at = w.members{h};
    verdict.alike(at) = verdict.alike(at) + w.alike(h) * verdict.P(h);
    if strcmp (w.kind{h}, 'sibling')
      verdict.resemble(at) = verdict.resemble(at) + verdict.P(h);
    else
      verdict.include(at) = verdict.include(at) + verdict.P(h);
    end
  end
  verdict.null = verdict.P(1);
  verdict.misfit = sum (verdict.P(strcmp (w.kind, 'discrepancy')));
  verdict.unlisted = verdict.misfit + sum (verdict.resemble);
  verdict.total = verdict.include + verdict.resemble;
  [~, verdict.top] = max ([verdict.total, 0]);
  [sorted, order] = sort (-verdict.total);
  most = cumsum (-sorted);
  verdict.likely = order(1:find (most >= 0.95 * max ([most, realmin]), 1));
end

%!shared w, models, like
%! models = struct ('names', {{'a', 'b', 'c'}}, 'siblings', {{{}, {}, {}}});
%! models.options = gapOptions ([]);
%! w = struct ('logE', [0, 9, 0, 0, 0, 0, 0, 0, 0]);
%! w.logPrior = log ([0.4, 0.13, 0.13, 0.13, 0.03, 0.02, 0.02, 0.02, 0.06]);
%! w.members = {[], 1, 2, 3, [1, 2], 1, 2, 3, []};
%! w.kind = [{'null'}, repmat({'single'}, 1, 3), {'pair'}, ...
%!           repmat({'sibling'}, 1, 3), {'discrepancy'}];
%! w.gate.p = 0.001;
%! w.screen = struct ('cosine', [1, 0.99, 0; 0.99, 1, 0; 0, 0, 1], ...
%!                    'size', [10, 10, 10]);
%! [w.phi, w.atLimit, w.ess] = deal (0.5 * ones (9, 1), zeros (1, 9), ...
%!                                   400 * ones (1, 9));
%! [w.top, w.exclude] = deal (1, log (20));
%! w.alike = [0, 1, 1, 1, 1, 0.3, 0.3, 0.3, 0];
%! like = @(at, logE) setfield (w, 'logE', setfield (w.logE, {at}, logE));
%!test
%! % what a change of the evidence makes of the verdict: a gate that is shut, as
%! % likely as another, any misfit, what resembles a but is not it, half of it
%! % what resembles a too loosely, a collapsed integral
%! cases = {w, 'named', 1, ''; ...
%!          setfield(w, 'gate', struct ('p', 0.2)), 'no gap', [], 'gate'; ...
%!          like(3, 9), 'group', [1, 2], 'group'; ...
%!          like(9, 12), 'none of the listed', [], ''; ...
%!          like(6, 14), 'none of the listed', [], ''; ...
%!          like(6, 10.5), 'group', 1, 'look-alike'; ...
%!          setfield(w, 'ess', setfield (w.ess, {2}, 30)), 'undecided', [], ...
%!          'integral'}';
%! for one = cases
%!   v = judgeCase (one{1}, models);
%!   assert ({v.kind, v.guard}, one([2, 4])');
%!   assert (isequal (v.effects, one{3}) || isempty ([v.effects, one{3}]));
%!   assert (v.lookAlike, strcmp (one{4}, 'look-alike'));
%!   assert (sum (v.P), 1, 1e-12);
%!   assert (v.sameKind, strcmp (one{4}, 'group'));
%! end
%! % a group is of one kind where every two of it are alike
%! less = like (3, 9);
%! less.screen.cosine(1, 2) = 0.89;
%! v = judgeCase (less, models);
%! assert ({v.effects, v.sameKind}, {[1, 2], false});
%! assert (! isempty (strfind (judgeCase (like (6, 14), models).reason, ...
%!                             'resembles a')));
%!test
%! % a poor integral of a lesser hypothesis takes a name away where it may make
%! % another verdict: b has 0.08 of the probability of a, 0.1 are a rival's
%! poor = @(w, at, ess) setfield (w, 'ess', setfield (w.ess, {at}, ess));
%! for c = {like(5, 7), 41, 'named'; like(3, 6.5), 41, 'undecided'; ...
%!          like(5, 7), 0, 'undecided'; like(3, 6.5), 400, 'named'}'
%!   at = find (c{1}.logE ~= w.logE);
%!   v = judgeCase (poor (c{1}, at, c{2}), models);
%!   assert (v.P(at) > 0.01);
%!   assert (v.kind, c{3});
%!   assert (strcmp (v.guard, 'integral'), strcmp (c{3}, 'undecided'));
%! end
%!test
%! % what kind of cause it is stands; that it is this very one is said where a
%! % look-alike is excluded, and where no other cause of its family is left out
%! v = judgeCase (setfield (w, 'exclude', 0.5), models);
%! assert ({v.kind, v.effects, v.lookAlike, v.guard}, {'named', 1, true, ''});
%! known = setfield (models, 'siblings', {{'d'}, {}, {}});
%! v = judgeCase (w, known);
%! assert ({v.kind, v.lookAlike}, {'named', true});
%! assert (! isempty (strfind (v.reason, 'told from d')));
%! % by hand: the effect, its pair, three tenths of its sibling
%! assert (v.alike(1), v.P * [0; 1; 0; 0; 1; 0.3; 0; 0; 0], 1e-12);
%!test
%! % a true cause may stand at the end of its range: named, and said
%! v = judgeCase (setfield (w, 'atLimit', 0.9 * ones (1, 9)), models);
%! assert (v.kind, 'named');
%! assert (! isempty (strfind (v.reason, 'end of its plausible range')));
%!test
%! % one effect is sure, and one of the two others acts with it
%! x = like ([2, 4, 5], [5, 15, 15.5]);
%! x.members(4:6) = {[1, 2], [1, 3], 1};
%! x.kind(4:6) = {'pair', 'pair', 'sibling'};
%! x.screen.cosine = eye (3);
%! v = judgeCase (x, models);
%! assert ({v.kind, v.effects, v.partners}, {'named', 1, [2, 3]});
%!test
%! % probabilities of an effect, of what is not listed, the fewest of all
%! x = struct ('logPrior', log ([0.5, 0.3, 0.1, 0.1]), 'logE', zeros (1, 4), ...
%!             'kind', {w.kind([1, 2, 6, 9])}, 'members', {{[], 1, 1, []}}, ...
%!             'alike', [0, 1, 0.3, 0], 'gate', struct ('p', 1), 'ess', NaN);
%! v = judgeCase (x, setfield (models, 'names', {'a'}));
%! assert ([v.total, v.include, v.unlisted, v.likely], [0.4, 0.3, 0.2, 1], ...
%!         1e-12);
