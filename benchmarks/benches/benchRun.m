% BENCHRUN  Runs a bench once, outside any calibration, and measures it.
%
% CALL: [RESULTS, SECONDS] = benchRun (FOLDER, MODEL, VARIABLES, PREPARE)
%
% FOLDER     text, folder of the run; made, or taken as it is if a finished
%            run lies in it
% MODEL      text, name of a bench in DEMmodels, or the path of another model's
%            folder
% VARIABLES  scalar struct of what is appended to its data.head
% PREPARE    optional shell command, carried out in the folder before the run
% RESULTS    1 x m, see the bench's results.csv; NaN if the run is not sane; 1 x
%            0 of a model without measureBench.m
% SECONDS    CPU time of the run (s)
%
% See also: effectSigns, benchLaws
function [results, seconds] = benchRun (folder, model, variables, prepare)
  root = fileparts (fileparts (which ('startToolbox')));
  source = fullfile (root, 'DEMmodels', model);
  if ~isfolder (source)
    source = model;
  end
  if exist (fullfile (folder, 'seconds'), 'file') ~= 2
    if nargin < 4
      prepare = 'true';
    end
    system (sprintf ('rm -rf "%s"; mkdir -p "%s"', folder, folder));
    system (sprintf ('cp -rL "%s"/. "%s"', source, folder));
    fid = fopen (fullfile (folder, 'data.head'), 'a');
    for name = fieldnames (variables).'
      fprintf (fid, "variable %s equal %.17g\n", name{1}, ...
               variables.(name{1}));
    end
    fclose (fid);
    system (sprintf (['cd "%s" && %s && export ' ...
                      'OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_pml=ob1 ' ...
                      'OMPI_MCA_btl=self,vader TIMEFORMAT=%%U && bash -c ' ...
                      '"time bash runscript > out 2> err < /dev/null" ' ...
                      '2> seconds.part; mv seconds.part seconds'], ...
                     folder, prepare));
  end
  seconds = str2double (fileread (fullfile (folder, 'seconds')));
  results = zeros (1, 0);
  funs = fullfile (source, 'OctaveFuns');
  if exist (fullfile (funs, 'measureBench.m'), 'file') ~= 2
    return
  end
  addpath (funs);
  tidy = onCleanup (@() rmpath (funs));
  results = cell2mat (namedResults (@measureBench, folder, source));
end

% SPDX-License-Identifier: GPL-3.0-only
