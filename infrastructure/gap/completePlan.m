% COMPLETEPLAN  Runs the plan of a case where too few neutral runs are there.
%
% CALL: DATA = completePlan (DATA, CASE, EVALUATE, SAY)
%
%   DATA      of gatherRuns
%   CASE      see newCase;  EVALUATE  see newEvaluate
%   SAY       function handle that takes one line of text
%
% A diagnosis wants 6 (d + 1) neutral sets, 40 at most, if it may run them;
% without new runs it takes what is there.
%
% See also: gatherRuns, diagnoseGap

function data = completePlan (data, Case, evaluate, say)
  d = numel (Case.names);
  phi = neutralEffects (Case);
  neutral = all (data.E == phi, 2) & all (isfinite (data.Z), 2);
  have = rows (unique (data.X(neutral, :), 'rows'));
  wanted = max (Case.options.numOfSam, min (40, 6 * d + 6));
  missing = min (wanted - have, ...
                 floor (Case.options.maxNewRuns / numel (Case.models)));
  if missing < 1
    return
  end
  say (sprintf ('plan: %d neutral sets there, %d more', have, missing));
  P = planBeside (data.X(neutral, :), missing, Case);
  Z = evaluate (P, ones (rows (P), 1), 'plan');
  isTried = ~any (isna (Z), 2);
  n = sum (isTried);
  data = addRows (data, P(isTried, :), Z(isTried, :), ones (n, 1), 'plan', ...
                  repmat (phi, n, 1));
end
