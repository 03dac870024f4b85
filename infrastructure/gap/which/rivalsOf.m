% RIVALSOF  Effects that explain the data without the ones that seem sure.
%
% CALL: RIVAL = rivalsOf (W, VERDICT, STRONG, OPTIONS)
%
%   W        struct of caseEvidence;  VERDICT  struct of judgeCase
%   STRONG   1 x m, numbers of the effects that seem sure
%   OPTIONS  struct: othersAt, alikeAt (see gapOptions)
%   RIVAL    1 x K logical
%
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

%!shared w, verdict, options
%! w.members = {1, [1, 2], [1, 3], 2, []};
%! w.screen.cosine = eye (3);
%! options = struct ('othersAt', 0.1, 'alikeAt', 0.7);
%! verdict = struct ('P', [0.3, 0.35, 0.2, 0.05, 0.1], 'total', ...
%!                   [0.85, 0.4, 0.2]);
%!assert (rivalsOf (w, verdict, 1, options), logical ([0, 0, 0]))
%!test
%! sharper = setfield (options, 'othersAt', 0.05);
%! assert (rivalsOf (w, verdict, 1, sharper), logical ([0, 1, 0]));
%!test
%! % one that looks like the strong one, and stands beside it more often than
%! % not, may take its place
%! alike = w;
%! alike.screen.cosine(2, 1) = -0.8;
%! assert (rivalsOf (alike, verdict, 1, options), logical ([0, 0, 0]));
%! verdict.P = [0.2, 0.45, 0.2, 0.05, 0.1];
%! assert (rivalsOf (alike, verdict, 1, options), logical ([0, 1, 0]));
%! alike.screen.cosine(2, 1) = 0.6;
%! assert (rivalsOf (alike, verdict, 1, options), logical ([0, 0, 0]));
%!test
%! % of a sure pair, a third effect takes the place of either half, and needs
%! % half as much for it
%! verdict.total(2) = 0.8;
%! assert (rivalsOf (w, verdict, [1, 2], options), logical ([0, 0, 1]));
%! verdict.P = [0.3, 0.55, 0.06, 0, 0.1];
%! assert (rivalsOf (w, verdict, [1, 2], options), logical ([0, 0, 1]));
%! assert (rivalsOf (w, verdict, 1, options), logical ([0, 0, 0]));
