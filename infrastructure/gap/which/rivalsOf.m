% RIVALSOF  Effects that explain the data without the ones that seem sure.
%
% CALL: RIVAL = rivalsOf (W, VERDICT, STRONG, SHARE)
%
%   W        struct of weighCase;  VERDICT  struct of openVerdict
%   STRONG   1 x m, numbers of the effects that seem sure
%   SHARE    scalar, share of their least probability that makes a rival
%   RIVAL    1 x K logical
%
% What counts is the probability of the hypotheses that hold the effect and lack
% one of STRONG. An effect that is likely only beside them is a partner.
%
% See also: judgeCase

function rival = rivalsOf (w, verdict, strong, share)
  without = cellfun (@(m) ~all (ismember (strong, m)), w.members);
  rival = false (size (verdict.total));
  for k = setdiff (1:numel (rival), strong)
    holds = cellfun (@(m) any (m == k), w.members);
    rival(k) = sum (verdict.P(holds & without)) > ...
               share * min (verdict.total(strong));
  end
end

%!shared w, verdict
%! w.members = {1, [1, 2], [1, 3], 2, []};
%! verdict = struct ('P', [0.3, 0.35, 0.2, 0.05, 0.1], 'total', ...
%!                   [0.85, 0.4, 0.2]);
%!assert (rivalsOf (w, verdict, 1, 0.1), logical ([0, 0, 0]))
%!assert (rivalsOf (w, verdict, 1, 0.05), logical ([0, 1, 0]))
%!test % of a sure pair, a third effect takes the place of either half
%! verdict.total(2) = 0.8;
%! assert (rivalsOf (w, verdict, [1, 2], 0.1), logical ([0, 0, 1]));
