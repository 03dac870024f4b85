% JUDGECASE  Turns evidences into a verdict, or into an honest abstention.
%
% CALL: VERDICT = judgeCase (W, MODELS)
%
%   W        struct of weighCase
%   MODELS   struct of makeModels: nameAt, level, temperature, names, siblings
%   VERDICT  struct
%     kind      'no gap', 'named', 'group', 'none of the listed' or 'undecided'
%     effects   numbers of the effects it names (one or two, or a group)
%     reason    text, one sentence
%     P         1 x H, probability of each hypothesis of W
%     include   1 x K, probability that the effect takes part
%     null, unlisted   probabilities;  likely  1 x m, smallest set of effects
%     (by P) that holds 95 % of what all listed ones have together
%     top       scalar, the likeliest effect
%
% P ~ prior * exp (log evidence / temperature). An effect is named only if all
% hold: there is a gap (W.gate.p < level), its probability reaches nameAt and is
% 3 times any other (save one that joins it in the likeliest hypothesis), no
% listed effect that noise takes for it is left over, its hypothesis fits (p >=
% 0.05), its strength is not at the end of its range, its surrogate is not
% vague, and nothing unlisted is known to look alike.
%
% See also: weighCase, calibrateVerdict

function verdict = judgeCase (w, models)
  logP = w.logPrior + w.logE / models.temperature;
  verdict = struct ('kind', 'undecided', 'effects', [], 'reason', '');
  verdict.P = exp (logP - logSumExp (logP));
  K = numel (models.names);
  verdict.include = zeros (1, K);
  for h = 1:numel (verdict.P)
    at = w.members{h};
    verdict.include(at) = verdict.include(at) + verdict.P(h);
  end
  verdict.null = verdict.P(1);
  verdict.unlisted = verdict.P(end);
  [~, verdict.top] = max ([verdict.include, 0]);
  verdict.likely = smallestSet (verdict.include);
  if w.gate.p >= models.level
    verdict.kind = 'no gap';
    verdict.reason = sprintf (['the misfit is what noise alone would make ' ...
                               '(p = %.2f)'], w.gate.p);
  elseif isUnlisted (w, verdict)
    verdict.kind = 'none of the listed';
    verdict.reason = sprintf (['there is a gap (p = %.3f) that no listed ' ...
                               'effect explains'], w.gate.p);
  elseif K > 0
    verdict = nameCause (verdict, w, models);
  else
    verdict.reason = sprintf (['there is a gap (p = %.3f), and no effect ' ...
                               'that has runs could explain it'], w.gate.p);
  end
end

function set = smallestSet (include)
  [sorted, order] = sort (-include);
  whole = cumsum (-sorted);
  last = find (whole >= 0.95 * max ([whole, eps]), 1);
  set = order(1:last);
end

function yes = isUnlisted (w, verdict)
  listed = 1:numel (w.fitP) - 1;
  [~, best] = max (verdict.P(listed));
  yes = verdict.unlisted >= 0.5 || max (w.fitP(listed)) < 0.01 || ...
        (w.fitP(best) < 0.01 && verdict.unlisted > 0.2);
end

function verdict = nameCause (verdict, w, models)
  named = find (verdict.include >= models.nameAt);
  top = verdict.top;
  if isempty (named)
    verdict = nameGroup (verdict, w, models, top);
    return
  end
  others = verdict.include;
  others(named) = 0;
  holding = find (cellfun (@(m) all (ismember (named, m)), w.members));
  [~, at] = max ([verdict.P(holding), 0]);
  holding(end + 1) = 1;
  best = holding(at);
  looksLike = [models.siblings{named}];
  mimics = mimicsOf (w, verdict, named);
  if isempty (w.members{best})
    verdict.reason = 'two effects are likely but not both together';
  elseif max ([others, 0]) * 3 > min (verdict.include(named)) && ...
         numel (w.members{best}) == numel (named)
    verdict.reason = 'a second effect is nearly as likely';
  elseif w.fitP(best) < 0.05
    verdict.reason = sprintf (['%s explains most of the gap, but what it ' ...
                               'leaves does not fit (p = %.3f)'], ...
                              models.names{top}, w.fitP(best));
  elseif w.atLimit(best) > 0.5
    verdict.reason = sprintf (['%s would have to be stronger than its ' ...
                               'plausible range'], models.names{top});
  elseif w.vague(best) > 0.4
    verdict.reason = sprintf (['%s is likely, but too few runs show what ' ...
                               'it does'], models.names{top});
  elseif ~isempty (mimics)
    verdict.kind = 'group';
    verdict.effects = sort ([named, mimics]);
    verdict.reason = ['the likeliest one looks too much like the others to ' ...
                      'be named alone'];
  elseif ~isempty (looksLike)
    verdict.kind = 'group';
    verdict.effects = named;
    verdict.reason = ['it cannot be told from ', strjoin(looksLike, ', '), ...
                      ', which is not listed or has no runs'];
  else
    verdict.kind = 'named';
    verdict.effects = named;
    verdict.reason = sprintf ('probability %.2f', min (verdict.include(named)));
    joins = setdiff (w.members{best}, named);
    if ~isempty (joins)
      verdict.reason = sprintf ('%s; fits best together with %s (%.2f)', ...
                                verdict.reason, models.names{joins(1)}, ...
                                verdict.include(joins(1)));
    end
  end
end

% Listed effects that noise would take for a named one, and not yet ruled out.
function mimics = mimicsOf (w, verdict, named)
  mimics = [];
  for k = named
    d = abs (w.phi(1 + k, 1)) * w.screen.size(k);
    alike = confusion (w.screen.cosine(k, :), d) > 0.1 & ...
            verdict.include > 0.02;
    alike(named) = false;
    mimics = union (mimics, find (alike));
  end
end

% Effects whose signatures differ by less than the noise share the verdict.
function verdict = nameGroup (verdict, w, models, top)
  d = abs (w.phi(1 + top, 1)) * w.screen.size(top);
  alike = confusion (w.screen.cosine(top, :), d) > 0.1 & ...
          verdict.include > 0.02;
  alike(top) = true;
  members = find (alike);
  holding = cellfun (@(m) ~isempty (intersect (members, m)), w.members);
  together = sum (verdict.P(holding));
  [~, best] = max (verdict.P .* holding);
  if numel (members) > 1 && together >= models.nameAt && ...
     w.fitP(best) >= 0.05 && w.atLimit(best) <= 0.5
    verdict.kind = 'group';
    verdict.effects = members;
    verdict.reason = sprintf (['one of them with probability %.2f; their ' ...
                               'signatures differ by less than the noise'], ...
                              together);
  else
    verdict.reason = 'no single cause is likely enough';
  end
end

%!shared w, models
%! models = struct ('names', {{'a', 'b', 'c'}}, 'siblings', {{{}, {}, {}}}, ...
%!                  'nameAt', 0.8, 'level', 0.05, 'temperature', 1);
%! w = struct ('logE', [0, 9, 0, 0, 0], 'fitP', [0.001, 0.4, 0.3, 0.3, 1]);
%! w.logPrior = log ([0.4, 0.13, 0.13, 0.13, 0.1]);
%! w.members = {[], 1, 2, 3, []};
%! w.kind = {'null', 'single', 'single', 'single', 'unlisted'};
%! w.gate = struct ('p', 0.001);
%! w.screen = struct ('cosine', [1, 0.99, 0; 0.99, 1, 0; 0, 0, 1], ...
%!                    'size', [10, 10, 10]);
%! w.phi = repmat ([0.5, 0.3, 0.7], 5, 1);
%! w.atLimit = zeros (1, 5);
%! w.vague = zeros (1, 5);
%!test
%! v = judgeCase (w, models);
%! assert (v.kind, 'named');
%! assert (v.effects, 1);
%! assert (sum (v.P), 1, 1e-12);
%!test
%! x = w;
%! x.gate.p = 0.2;
%! assert (judgeCase (x, models).kind, 'no gap');
%!test
%! x = w;
%! x.logE(3) = 9;
%! v = judgeCase (x, models);
%! assert (v.kind, 'group');
%! assert (v.effects, [1, 2]);
%!test
%! x = w;
%! x.logE(4) = 9;
%! assert (judgeCase (x, models).kind, 'undecided');
%!test
%! x = w;
%! x.logE(5) = 12;
%! assert (judgeCase (x, models).kind, 'none of the listed');
%!test
%! x = w;
%! x.fitP(2) = 0.03;
%! assert (judgeCase (x, models).kind, 'undecided');
%!test
%! x = w;
%! x.atLimit(2) = 0.9;
%! assert (judgeCase (x, models).kind, 'undecided');
%!test
%! m = models;
%! m.siblings{1} = {'d'};
%! assert (judgeCase (w, m).kind, 'group');
