% NAMECAUSE  Which effects a verdict names, where a listed one may be the cause.
%
% CALL: VERDICT = nameCause (VERDICT, W, MODELS)
%
%   VERDICT, W, MODELS  see judgeCase; of VERDICT kind, effects, lookAlike,
%                       partners, guard and reason come back as they are where
%                       nothing can be named

function verdict = nameCause (verdict, w, models)
  options = models.options;
  top = verdict.top;
  if verdict.resemble(top) > max (options.misfitAt, ...
                                  2 * verdict.include(top))
    verdict.kind = 'none of the listed';
    verdict.reason = sprintf (['something resembles %s, but the data say ' ...
                               'it is not that'], models.names{top});
    return
  end
  strong = find (verdict.alike >= options.nameAt);
  isSure = ~isempty (strong);
  if ~isSure
    strong = find (verdict.total >= options.groupAt);
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
  if any (others)
    verdict.kind = 'group';
    verdict.guard = 'group';
    verdict.effects = sort ([strong, find(others)]);
    verdict.reason = ['the likeliest one looks too much like the others to ' ...
                      'be named alone'];
    return
  end
  verdict = sayCause (verdict, w, models, strong, isSure);
  verdict.partners = partnersOf (w, verdict, strong, options);
end

% A name, or where only what resembles the effect more loosely makes it likely
% a group of one; and whether it is this very one.
function verdict = sayCause (verdict, w, models, strong, isSure)
  options = models.options;
  missing = [models.siblings{strong}];
  isExcluded = all (ismember (strong, w.top)) && ...
               w.exclude >= log (options.exclude);
  verdict.kind = 'named';
  verdict.effects = strong;
  verdict.lookAlike = ~isempty (missing) || ~isExcluded || ~isSure;
  verdict.reason = sprintf ('probability %.2f', min (verdict.alike(strong)));
  if ~isSure
    verdict.kind = 'group';
    verdict.guard = 'look-alike';
    verdict.reason = sprintf (['that it is this one, or one whose mark is ' ...
                               'nearly the same, has a probability of ' ...
                               '%.2f'], min (verdict.alike(strong)));
  elseif ~isempty (missing)
    verdict.reason = ['it cannot be told from ', strjoin(missing, ', '), ...
                      ', which is not listed or has no runs'];
  elseif ~isExcluded
    verdict.reason = sprintf (['a cause of nearly the same mark (cosine ' ...
                               '0.9) is not excluded (odds %.1f to 1)'], ...
                              exp (min (w.exclude, 9)));
  end
  if max (w.atLimit(bestWith (w, verdict, strong))) > options.gluedAt
    verdict.reason = [verdict.reason, '; it stands at the end of its ' ...
                      'plausible range, or beyond'];
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
  [~, best] = max (verdict.P - 2 * ~holding);
end

% Effects that explain the data without STRONG, the ones that seem sure.
% What counts is the probability of the hypotheses that hold the effect and lack
% one of STRONG: a rival has othersAt of that of STRONG, or half of it against
% two, as a pair is two claims and shares the doubt. An effect that is likely
% only beside them is a partner, unless the two signatures are alike and they
% stand together in half of all: a pair of look-alikes is one of them, badly
% modelled, as often as it is both, and then all hypotheses count.
function rival = rivalsOf (w, verdict, strong, options)
  without = cellfun (@(m) ~all (ismember (strong, m)), w.members);
  least = min (verdict.total(strong));
  rival = false (size (verdict.total));
  for k = setdiff (1:numel (rival), strong)
    holds = cellfun (@(m) any (m == k), w.members);
    together = sum (verdict.P(holds & ~without));
    if max (abs (w.screen.cosine(k, strong))) < options.alikeAt || ...
       together < 0.5 * least
      holds = holds & without;
    end
    rival(k) = sum (verdict.P(holds)) > ...
               options.othersAt / numel (strong) * least;
  end
end

% The fewest likely effects that have groupAt together: two or three; more where
% the noise takes each of them for the likeliest one: of two Gaussians whose
% means are the signatures half their distance decides.
function verdict = nameGroup (verdict, w, models)
  [~, order] = sort (-verdict.total);
  top = verdict.top;
  singles = find (strcmp (w.kind, 'single'));
  d = abs (w.phi(singles(top))) * w.screen.size(top);
  half = d * sqrt (max (1 - w.screen.cosine(top, :), 0) / 2);
  alike = normalTail (half) > models.options.confusedAt;
  for n = 2:numel (order)
    set = order(1:n);
    if n > 3 && ~all (alike(setdiff (set, top)))
      return
    end
    holding = cellfun (@(m) any (any (set == m(:))), w.members);
    together = sum (verdict.P(holding));
    if together >= models.options.groupAt
      verdict.kind = 'group';
      verdict.guard = 'group';
      verdict.effects = sort (set);
      verdict.lookAlike = sum (verdict.resemble(set)) > models.options.caveatAt;
      verdict.reason = sprintf ('one of them with probability %.2f', together);
      return
    end
  end
end

%!shared w, verdict, models, named
%! w.members = {1, [1, 2], [1, 3], 2, []};
%! w.kind = {'single', 'pair', 'pair', 'single', 'discrepancy'};
%! w.screen = struct ('cosine', eye (3), 'size', [10, 10, 10]);
%! [w.phi, w.atLimit, w.top, w.exclude] = deal (0.5 * ones (5, 1), ...
%!                                              zeros (1, 5), 1, 9);
%! models = struct ('names', {{'a', 'b', 'c'}}, 'siblings', {{{}, {}, {}}});
%! models.options = setfield (gapOptions ([]), 'othersAt', 0.1);
%! verdict = struct ('P', [0.3, 0.35, 0.2, 0.05, 0.1], 'total', ...
%!                   [0.85, 0.4, 0.2], 'top', 1, 'kind', 'undecided', ...
%!                   'effects', []);
%! [verdict.include, verdict.alike] = deal (verdict.total);
%! verdict.resemble = zeros (1, 3);
%! named = @(w, verdict, models) nameCause (verdict, w, models).effects;
%!assert (named (w, verdict, models), 1)
%!test
%! sharper = setfield (models, 'options', setfield (models.options, ...
%!                                                  'othersAt', 0.05));
%! assert (named (w, verdict, sharper), [1, 2]);
%!test
%! % one that looks like the strong one, and stands beside it more often than
%! % not, may take its place
%! [alike, v] = deal (w, verdict);
%! alike.screen.cosine(2, 1) = -0.8;
%! assert (named (alike, v, models), 1);
%! v.P = [0.2, 0.45, 0.2, 0.05, 0.1];
%! assert (named (alike, v, models), [1, 2]);
%! alike.screen.cosine(2, 1) = 0.6;
%! assert (named (alike, v, models), 1);
%!test
%! % of a sure pair, a third effect takes the place of the lesser half, and
%! % needs half as much for it; without one both are named
%! v = verdict;
%! v.total(2) = 0.8;
%! for third = [0.2, 0.06]
%!   v.P = [0.3, 0.55, third, 0, 0.1];
%!   assert (named (w, v, models), 1);
%! end
%! v.P(3) = 0.02;
%! assert (named (w, v, models), [1, 2]);
%!test
%! % three that look alike, which stopped the judgement of an older version; a
%! % fourth only where it looks like them, too
%! w.members = {1, 2, 3, 4};
%! w.kind = repmat ({'single'}, 1, 4);
%! w.phi = 0.5 * ones (4, 1);
%! w.screen = struct ('cosine', 0.99 + 0.01 * eye (4), ...
%!                    'size', 10 * ones (1, 4));
%! P = [0.3, 0.28, 0.26, 0.16];
%! [verdict.P, verdict.total, verdict.alike, verdict.include] = deal (P);
%! verdict.resemble = zeros (1, 4);
%! assert (named (w, verdict, models), 1:3);
%! [verdict.P, verdict.total, verdict.alike] = deal (0.25 * ones (1, 4));
%! assert (named (w, verdict, models), 1:4);
%! w.screen.cosine = eye (4);
%! assert (nameCause (verdict, w, models).kind, 'undecided');
