% CAUSESOFVERDICT  What may have made what a diagnosis has found.
%
% CALL: LIST = causesOfVerdict (VERDICT, STUDY)
%
%   VERDICT  of judgeCase;  STUDY  struct problem, hypotheses, fits, evidence
%   LIST     see weighCauses; empty without a gap, as nothing has made it

function list = causesOfVerdict (verdict, study)
  problem = study.problem;
  if any (strcmp (verdict.kind, {'no gap', 'surrogate'}))
    % who sees no gap, or cannot tell, does not ask what made it
    problem.causes = [];
  end
  list = weighCauses (study.hypotheses, study.evidence.screen, ...
                      study.fits.calibrated.Q(1, :), problem);
end

%!test
%! study.hypotheses = handMadeHypotheses ();
%! study.evidence.screen = screenEffects (study.hypotheses.white, 0, [0, 0, 4, 4]);
%! study.fits.calibrated.Q = 0;
%! study.problem = struct ('reference', [], 'effects', ...
%!                         struct ('name', {'a', 'b'}, 'group', ''));
%! study.problem.causes = ...
%!   describeCause (struct ('name', 'one', 'label', 'one', 'question', '?', ...
%!                          'members', {{{'a'}, '', 0.5, 0.1}}));
%! of = @(kind) causesOfVerdict (struct ('kind', kind), study);
%! assert (of ('group')(1).name, 'one');
%! assert (isempty (of ('no gap')));

% SPDX-License-Identifier: GPL-3.0-only
