% JUDGECASE  Turns evidences into a verdict, or into an honest abstention.
%
% CALL: VERDICT = judgeCase (W, MODELS)
%
%   W        struct of caseEvidence
%   MODELS   struct of makeHypotheses
%   VERDICT  struct
%     kind      'no gap', 'named', 'group', 'none of the listed' or 'undecided'
%     effects   numbers of the effects it names (one or two, or a group)
%     lookAlike logical: or something that resembles them
%     partners  numbers of effects one of which acts together with a named one
%     guard     what withheld a name: '', 'range', 'integral', 'look-alike',
%               'group', 'gate'; diagnoseMatrices adds 'surrogate' and 'cure'
%     reason    text, one sentence
%     P         1 x H, probability of each hypothesis of W
%     include   1 x K, probability that the effect takes part
%     resemble  1 x K, that something not listed which resembles it does
%     null, unlisted (siblings and discrepancies) probabilities
%     likely    1 x m, fewest effects (by include + resemble) that hold 95 % of
%               what all have together;  top  scalar, the likeliest one
%
% P ~ prior * exp (log evidence). What is a gap is W.gate's matter; then:
% 'none of the listed' where misfits that resemble no effect, or that resemble
% one without being it, are likelier than not; a name where one effect (or pair)
% has probability nameAt, no other explains the data without it with a tenth of
% that, and the data exclude a look-alike of cosine 0.9; a group where that is
% not so but the effects left, or what resembles them, have nameAt together.
%
% See also: caseEvidence, rivalsOf, calibrateVerdict

function verdict = judgeCase (w, models)
  verdict = openVerdict (w, numel (models.names));
  weak = w.ess < models.options.leastPoints & verdict.P > 0.01;
  if w.gate.p >= models.options.level
    verdict.kind = 'no gap';
    verdict.guard = 'gate';
    verdict.reason = sprintf (['data without a gap give as much evidence ' ...
                               'for a cause with p = %.2f'], w.gate.p);
  elseif any (weak)
    verdict.guard = 'integral';
    verdict.reason = sprintf (['an integral rests on %.0f effective ' ...
                               'points; raise options.most'], ...
                              min (w.ess(weak)));
  elseif verdict.misfit >= models.options.misfitAt
    verdict.kind = 'none of the listed';
    verdict.reason = sprintf (['there is a gap (p = %.3f) that no listed ' ...
                               'effect explains'], w.gate.p);
  elseif isempty (models.names)
    verdict.reason = sprintf (['there is a gap (p = %.3f), and no effect ' ...
                               'that has runs could explain it'], w.gate.p);
  else
    verdict = nameCause (verdict, w, models);
  end
end

function verdict = nameCause (verdict, w, models)
  options = models.options;
  strong = find (verdict.total >= options.nameAt);
  top = verdict.top;
  if verdict.resemble(top) > max (options.misfitAt, ...
                                  2 * verdict.include(top))
    verdict.kind = 'none of the listed';
    verdict.reason = sprintf (['something resembles %s, but the data say ' ...
                               'it is not that'], models.names{top});
    return
  end
  if isempty (strong)
    verdict = nameGroup (verdict, w, models);
    return
  end
  others = rivalsOf (w, verdict, strong, options);
  if any (others) && numel (strong) > 1
    % of a pair the surer half, where the other half has rivals
    strong = top;
    others = rivalsOf (w, verdict, strong, options);
  end
  best = bestWith (w, verdict, strong);
  if w.atLimit(best) > options.gluedAt
    verdict.guard = 'range';
    verdict.reason = sprintf (['%s would have to be stronger than its ' ...
                               'plausible range'], models.names{top});
  elseif any (others)
    verdict.kind = 'group';
    verdict.guard = 'group';
    verdict.effects = sort ([strong, find(others)]);
    verdict.reason = ['the likeliest one looks too much like the others to ' ...
                      'be named alone'];
  else
    verdict = nameOrResemble (verdict, w, models, strong);
    verdict.partners = partnersOf (w, verdict, strong, options);
  end
end

function verdict = nameOrResemble (verdict, w, models, strong)
  verdict.kind = 'named';
  verdict.effects = strong;
  missing = [models.siblings{strong}];
  excluded = all (ismember (strong, w.top)) && ...
             w.exclude >= log (models.options.exclude);
  verdict.reason = sprintf ('probability %.2f', ...
                            min (verdict.include(strong)));
  if ~isempty (missing)
    verdict.kind = 'group';
    verdict.guard = 'look-alike';
    verdict.lookAlike = true;
    verdict.reason = ['it cannot be told from ', strjoin(missing, ', '), ...
                      ', which is not listed or has no runs'];
  elseif ~excluded
    verdict.kind = 'group';
    verdict.guard = 'look-alike';
    verdict.lookAlike = true;
    verdict.reason = sprintf (['the data do not exclude a cause nine ' ...
                               'tenths alike (odds %.1f to 1)'], ...
                              exp (min (w.exclude, 9)));
  end
end

% Effects one of which acts together with the strong one, likelier than not.
function joining = partnersOf (w, verdict, strong, options)
  joining = zeros (1, 0);
  pairs = find (strcmp (w.kind, 'pair'));
  holds = pairs(cellfun (@(m) any (ismember (strong, m)), w.members(pairs)));
  if numel (strong) > 1 || sum (verdict.P(holds)) < 0.5 * verdict.total(strong)
    return
  end
  for h = holds(verdict.P(holds) > options.partnerAt)
    joining = [joining, setdiff(w.members{h}, strong)];
  end
  joining = unique (joining);
end

function best = bestWith (w, verdict, strong)
  holding = cellfun (@(m) all (ismember (strong, m)), w.members) & ...
            ~strcmp (w.kind, 'sibling');
  if ~any (holding)
    holding = cellfun (@(m) any (ismember (strong, m)), w.members);
  end
  P = verdict.P;
  P(~holding) = -1;
  [~, best] = max (P);
end

% The fewest likely effects that have nameAt together: three, or more where the
% noise takes each of them for the likeliest one.
function verdict = nameGroup (verdict, w, models)
  [~, order] = sort (-verdict.total);
  top = verdict.top;
  singles = find (strcmp (w.kind, 'single'));
  d = abs (w.phi(singles(top))) * w.screen.size(top);
  alike = confusion (w.screen.cosine(top, :), d) > models.options.confusedAt;
  for n = 2:numel (order)
    set = order(1:n);
    if n > 3 && ~all (alike(setdiff (set, top)))
      return
    end
    holding = cellfun (@(m) any (any (set == m(:))), w.members);
    together = sum (verdict.P(holding));
    if together >= models.options.nameAt
      verdict.kind = 'group';
      verdict.guard = 'group';
      verdict.effects = sort (set);
      verdict.lookAlike = sum (verdict.resemble(set)) > models.options.caveatAt;
      verdict.reason = sprintf ('one of them with probability %.2f', together);
      return
    end
  end
end

%!shared w, models
%! models = struct ('names', {{'a', 'b', 'c'}}, 'siblings', {{{}, {}, {}}});
%! models.options = gapOptions ([]);
%! w = struct ('logE', [0, 9, 0, 0, 0, 0, 0, 0, 0]);
%! w.logPrior = log ([0.4, 0.13, 0.13, 0.13, 0.03, 0.02, 0.02, 0.02, 0.06]);
%! w.members = {[], 1, 2, 3, [1, 2], 1, 2, 3, []};
%! w.kind = {'null', 'single', 'single', 'single', 'pair', 'sibling', ...
%!           'sibling', 'sibling', 'discrepancy'};
%! w.gate = struct ('p', 0.001);
%! w.screen = struct ('cosine', [1, 0.99, 0; 0.99, 1, 0; 0, 0, 1], ...
%!                    'size', [10, 10, 10]);
%! w.phi = 0.5 * ones (9, 1);
%! w.atLimit = zeros (1, 9);
%! w.ess = 400 * ones (1, 9);
%! w.top = 1;
%! w.exclude = log (20);
%!test
%! v = judgeCase (w, models);
%! assert (isequal (v.kind, 'named') && isequal (v.effects, 1));
%! assert (sum (v.P), 1, 1e-12);
%!test
%! x = setfield (w, 'gate', struct ('p', 0.2));
%! assert (judgeCase (x, models).kind, 'no gap');
%!test
%! % as likely as another one: a group
%! x = w;
%! x.logE(3) = 9;
%! v = judgeCase (x, models);
%! assert (v.kind, 'group');
%! assert (v.effects, [1, 2]);
%!test
%! % three that look alike, which stopped the judgement of an older version
%! x = w;
%! x.logE(2:4) = [9, 8, 8];
%! x.screen.cosine = 0.99 + 0.01 * eye (3);
%! v = judgeCase (x, models);
%! assert (v.kind, 'group');
%! assert (v.effects, [1, 2, 3]);
%!test
%! x = w;
%! x.logE(9) = 12;
%! assert (judgeCase (x, models).kind, 'none of the listed');
%!test
%! % it resembles a listed one and is not that
%! x = w;
%! x.logE(6) = 14;
%! v = judgeCase (x, models);
%! assert (v.kind, 'none of the listed');
%! assert (~isempty (strfind (v.reason, 'resembles a')));
%!test
%! % data that a look-alike explains as well
%! x = w;
%! x.exclude = 0.5;
%! v = judgeCase (x, models);
%! assert (v.kind, 'group');
%! assert (v.lookAlike && isequal (v.effects, 1));
%!test
%! x = setfield (w, 'atLimit', 0.9 * ones (1, 9));
%! assert (judgeCase (x, models).kind, 'undecided');
%!test
%! m = models;
%! m.siblings{1} = {'d'};
%! assert (judgeCase (w, m).kind, 'group');
%!test
%! % no verdict from a collapsed integral
%! x = w;
%! x.ess(2) = 30;
%! v = judgeCase (x, models);
%! assert (v.kind, 'undecided');
%! assert (v.guard, 'integral');
%!test
%! % one effect is sure, and one of the two others acts with it
%! x = w;
%! x.members(4:6) = {[1, 2], [1, 3], 1};
%! x.kind(4:6) = {'pair', 'pair', 'sibling'};
%! x.logE(4:5) = [15, 15.5];
%! [x.logE(2), x.screen.cosine] = deal (5, eye (3));
%! v = judgeCase (x, models);
%! assert (v.kind, 'named');
%! assert (v.effects, 1);
%! assert (v.partners, [2, 3]);
