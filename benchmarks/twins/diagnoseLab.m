% DIAGNOSELAB  Diagnoses a foreign laboratory, with all runs that a plan makes.
%
% CALL: D = diagnoseLab (GIVEN, DATA, RUNS)
%
%   GIVEN, DATA  as of diagnoseMatrices;  RUNS  of runsOfLab
%   D            of diagnoseMatrices; nothing is calibrated on twins
%
% See also: planStudy, nextTestStudy

function d = diagnoseLab (given, data, runs)
  Case = struct ('names', {given.names}, 'options', struct ('seed', 1), ...
                 'coarse', []);
  options = gapBudget (Case, struct ('left', 1e4, 'perSet', 1), given, NaN);
  options.trials = 0;
  options.bootstrap = 99;
  d = diagnoseMatrices (given, data, options, runs);
end
