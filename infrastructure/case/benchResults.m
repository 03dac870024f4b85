% BENCHRESULTS  Results of a run of a model with a function measureBench.
%
% CALL: RES = benchResults (MEASURE, MODEL, FOLDERNAME)
%
%   MEASURE     function handle to measureBench.m in OctaveFuns/ of the model, see
%               namedResults; results.csv is that of this model
%   MODEL       name of the model's folder below optim/ (text)
%   FOLDERNAME  name of the run's folder (text)
%   RES         1 x m cell of scalars or curves, in the order of results.csv; NaN
%               where the run does not tell
%
% What getResults.m of a test rig returns: it has the run's place in the global
% path, as published.
%
% Throws DEcalioc:namedResults:noNames, see namedResults.
%
% See also: namedResults

function res = benchResults (measure, model, folderName)
  %| pragma Justify (metric, "globals", "published way in");
  global path
  funs = fileparts (functions (measure).file);
  res = namedResults (measure, [path, 'optim/', model, '/', folderName, '/'], ...
                      fileparts (funs));
end

%!test
%! % the model is the folder of the function, the run is below the global path
%! place = tempname ();
%! funs = fullfile (place, 'Bench', 'OctaveFuns');
%! run = fullfile (place, 'optim', 'Bench', '0001');
%! cellfun (@(folder) system (['mkdir -p ', folder]), {funs, run});
%! writeAtomic (fullfile (place, 'Bench', 'results.csv'), ...
%!   "name,kind,unit,series,at,text\nmass,mass,kg,,,m\nslope,angle,deg,,,s\n");
%! writeAtomic (fullfile (funs, 'measureBench.m'), ...
%!   "function r = measureBench (folder)\nr.slope = load ([folder, 'z']);\nend\n");
%! writeAtomic (fullfile (run, 'z'), '30');
%! back = addpath (funs);
%! tidy = onCleanup (@() builtin ('path', back));
%! global path
%! path = [place, '/'];
%! res = benchResults (@measureBench, 'Bench', '0001');
%! clear -global path
%! assert (res, {NaN, 30});

% SPDX-License-Identifier: GPL-3.0-only
