% RIVALSOF  Effects that explain the data without the ones that seem sure.
%
% CALL: RIVAL = rivalsOf (W, VERDICT, STRONG, OPTIONS)
%
%   W        struct of weighCase;  VERDICT  struct of openVerdict
%   STRONG   1 x m, numbers of the effects that seem sure
%   OPTIONS  struct: othersAt, alikeAt (see gapOptions)
%   RIVAL    1 x K logical
%
% What counts is the probability of the hypotheses that hold the effect and lack
% one of STRONG. An effect that is likely only beside them is a partner, unless
% the two signatures are alike: a pair of look-alikes is one of them, badly
% modelled, as often as it is both, and then all hypotheses count.
%
% See also: judgeCase

function rival = rivalsOf (w, verdict, strong, options)
  without = cellfun (@(m) ~all (ismember (strong, m)), w.members);
  rival = false (size (verdict.total));
  for k = setdiff (1:numel (rival), strong)
    holds = cellfun (@(m) any (m == k), w.members);
    if max (abs (w.screen.cosine(k, strong))) < options.alikeAt
      holds = holds & without;
    end
    rival(k) = sum (verdict.P(holds)) > ...
               options.othersAt * min (verdict.total(strong));
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
%! % a partner that looks like the strong one may take its place
%! alike = w;
%! alike.screen.cosine(3, 1) = -0.8;
%! assert (rivalsOf (alike, verdict, 1, options), logical ([0, 0, 1]));
%!test
%! % of a sure pair, a third effect takes the place of either half
%! verdict.total(2) = 0.8;
%! assert (rivalsOf (w, verdict, [1, 2], options), logical ([0, 0, 1]));
