% STRENGTHALONE  Median and 90 % interval of an effect where it acts alone.
%
% CALL: Q = strengthAlone (EVIDENCE, HYPOTHESES, K)
%
%   EVIDENCE, HYPOTHESES  see caseEvidence
%   K          number of the effect in the list of HYPOTHESES
%   Q          1 x 3: median, both ends; NaN where it was not integrated

function q = strengthAlone (evidence, hypotheses, k)
  q = NaN (1, 3);
  row = hypotheses.singles(k);
  sample = evidence.posterior{row};
  if ~isempty (sample.Q)
    effect = hypotheses.white.effect(k);
    q = strengthInterval (sample.Q(:, hypotheses.white.p + 1), sample.cautious, ...
                          effect.range, effect.scale);
    q(1) = evidence.phi(row);
  end
end

%!test
%! pkg load stk
%! [given, data] = smallGapLab ();
%! options = gapOptions ([]);
%! given.value = mean (data.Z);
%! problem = newProblem (given);
%! hypotheses = makeHypotheses (problem, fitEmulator (problem, data, options), ...
%!                          options);
%! hypotheses = gapReference (hypotheses);
%! evidence = caseEvidence (hypotheses, fitLibrary (hypotheses, given.value), 1);
%! q = strengthAlone (evidence, hypotheses, 1);
%! assert (q(2) <= q(1) && q(1) <= q(3));
%! assert (q(1), evidence.phi(hypotheses.singles(1)));

% SPDX-License-Identifier: GPL-3.0-only
