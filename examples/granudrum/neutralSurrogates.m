% NEUTRALSURROGATES  Kriging of the null model's surfaces over the parameters.
%
% CALL: [SURROGATES, PROBLEM, DATA] = neutralSurrogates (CASE, OWN)
%
%   CASE        see newCase, with effects
%   OWN         1 x T logical, the targets that count as measured
%   SURROGATES  1 x T struct array of fitSurrogates, of all targets
%   PROBLEM     struct of newProblem, with the targets of OWN alone
%   DATA        the runs without effects that gave all results, see gatherRuns
%
% See also: drawPredictionSets, leaveOneSpeedOut

function [surrogates, problem, data] = neutralSurrogates (Case, own)
  data = gatherRuns (Case);
  plain = all (data.E == neutralEffects (Case), 2) & ...
          all (isfinite (data.Z), 2);
  data = addRows (newData (numel (Case.names), numel (Case.targets)), ...
                  data.X(plain, :), data.Z(plain, :), ...
                  data.replicate(plain), 'import');
  surrogates = fitSurrogates (data, newProblem (Case, []));
  Case.targets = Case.targets(own);
  problem = newProblem (Case, []);
end
