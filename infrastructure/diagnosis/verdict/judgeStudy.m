% JUDGESTUDY  The verdict on a study, or whose fault it is that none can be given.
%
% CALL: [VERDICT, EVIDENCE] = judgeStudy (STUDY, SIDE)
%
%   STUDY    of makeStudy, judged at its hypotheses.options.significance
%   SIDE     of sideSignals
%   VERDICT  of judgeCase, or of kind and guard 'surrogate': more runs come first
%   EVIDENCE of caseEvidence

function [verdict, evidence] = judgeStudy (study, side)
  evidence = caseEvidence (study.hypotheses, study.fits, 1);
  verdict = judgeCase (evidence, study.hypotheses);
  verdict = blameSurrogates (verdict, study, side);
end

% Surrogates are to blame where they contradict their own runs, or where there
% is no name and surer ones, all else equal, would give another verdict.
function verdict = blameSurrogates (verdict, study, side)
  said = any (strcmp (verdict.kind, {'named', 'group'}));
  reason = '';
  if side.blameSurrogate
    reason = side.reason;
  elseif side.vague && ~said
    % what more runs could change, at best
    other = judgeSurer (study);
    if ~strcmp (other.kind, verdict.kind)
      n = rows (study.emulator.base.X);
      share = mean (side.share(study.problem.used));
      reason = sprintf (['%s. With surer ones it would be: %s. About %d ' ...
                         'more sets near the calibrated one halve their ' ...
                         'part'], ...
                        side.reason, other.kind, ceil (n * share));
    end
  end
  if ~isempty (reason)
    verdict.kind = 'surrogate';
    verdict.guard = 'surrogate';
    verdict.effects = zeros (1, 0);
    verdict.sameKind = false;
    verdict.reason = reason;
  end
end

% The same data, with a twentieth of the surrogates' variance.
function verdict = judgeSurer (study)
  emulator = study.emulator;
  emulator.surrogateVar = emulator.surrogateVar / 20;
  emulator.fitVar = emulator.fitVar / 20;
  for k = 1:numel (emulator.effect)
    emulator.effect(k).misfit = emulator.effect(k).misfit / 20;
    emulator.effect(k).root = emulator.effect(k).root / sqrt (20);
  end
  sure = makeStudy (study.problem, emulator, study.hypotheses.options);
  verdict = judgeCase (caseEvidence (sure.hypotheses, sure.fits, 1), sure.hypotheses);
end

%!test
%! % surrogates that contradict their own runs are to blame, whatever p says
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0, 0]);
%! options = gapOptions (struct ('trend', 'affine', 'twins', 60));
%! problem = newProblem (given);
%! study = makeStudy (problem, emulate (problem, data, options), options);
%! side = struct ('blameSurrogate', false, 'vague', false, 'reason', '');
%! assert (judgeStudy (study, side).effects, 3);
%! side = struct ('blameSurrogate', true, 'vague', false, 'reason', 'why');
%! verdict = judgeStudy (study, side);
%! assert ({verdict.kind, verdict.effects, verdict.reason}, ...
%!         {'surrogate', zeros(1, 0), 'why'});

% SPDX-License-Identifier: GPL-3.0-only
