% DIAGNOSELAB  Diagnoses a foreign laboratory, with all runs that a plan makes.
%
% CALL: D = diagnoseLab (GIVEN, DATA, RUNS)
%
%   GIVEN, DATA  as of diagnoseMatrices;  RUNS  of runsOfLab
%   D            of diagnoseMatrices; nothing is calibrated on twins
%
% See also: planStudy

function d = diagnoseLab (given, data, runs)
  options = gapOptions ([]);
  options.maxNewRuns = foreseeSets (newProblem (given).effects, 1e4, options);
  options.bootstrap = 99;
  d = diagnoseMatrices (given, data, options, runs);
end
