% NAMEGROUP  The fewest likely effects that have groupAt together.
%
% CALL: VERDICT = nameGroup (VERDICT, W, MODELS)
%
%   VERDICT, W, MODELS  see judgeCase; VERDICT comes back as it is where there
%                       is no such group
%
% Two or three; more where the noise takes each of them for the likeliest one.

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

%!test
%! % three that look alike, which stopped the judgement of an older version; a
%! % fourth only where it looks like them, too
%! models.options = gapOptions ([]);
%! w.members = {1, 2, 3, 4};
%! w.kind = repmat ({'single'}, 1, 4);
%! w.phi = 0.5 * ones (4, 1);
%! w.screen = struct ('cosine', 0.99 + 0.01 * eye (4), ...
%!                    'size', 10 * ones (1, 4));
%! P = [0.3, 0.28, 0.26, 0.16];
%! verdict = struct ('kind', 'undecided', 'P', P, 'total', P, 'top', 1, ...
%!                   'resemble', zeros (1, 4), 'effects', []);
%! assert (nameGroup (verdict, w, models).effects, 1:3);
%! verdict.total(:) = 0.25;
%! verdict.P = verdict.total;
%! assert (nameGroup (verdict, w, models).effects, 1:4);
%! w.screen.cosine = eye (4);
%! assert (nameGroup (verdict, w, models).kind, 'undecided');
