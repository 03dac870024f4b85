% NATSBEHIND  How much less likely each effect is without the ones that seem sure.
%
% CALL: NATS = natsBehind (EVIDENCE, VERDICT, STRONG)
%
%   EVIDENCE  of caseEvidence: members;  VERDICT  of judgeCase: P, include
%   STRONG   1 x s, numbers of effects
%   NATS     1 x K, log (least of VERDICT.include(STRONG)) less the log of the
%            probability of all hypotheses that hold the effect and lack one of
%            STRONG; Inf for STRONG themselves. An effect that is likely only
%            beside them is a partner, no rival

function nats = natsBehind (evidence, verdict, strong)
  without = cellfun (@(m) ~all (ismember (strong, m)), evidence.members);
  nats = Inf (size (verdict.include));
  for k = setdiff (1:numel (nats), strong)
    % k beside all of STRONG is its partner, not its rival
    holds = cellfun (@(m) any (m == k), evidence.members);
    nats(k) = log (min (verdict.include(strong))) - ...
              log (sum (verdict.P(holds & without)));
  end
end

%!test
%! evidence.members = {[], 1, 2, [1, 3]};
%! verdict = struct ('P', [0.1, 0.5, 0.1, 0.3], 'include', [0.8, 0.1, 0.3]);
%! assert (natsBehind (evidence, verdict, 1), [Inf, log(8), Inf], 1e-12);
%! assert (natsBehind (evidence, verdict, [1, 3]), [Inf, log(3), Inf], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
