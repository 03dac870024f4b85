% BENCHTRIAL  Runs a bench at test scale and returns what it leaves.
%
% CALL: [TEXT, FAULT] = benchTrial (MODEL, VARIABLES, LAW)
%
% MODEL      text, name of a bench, or the path of another model's folder
% VARIABLES  scalar struct appended to its data.head
% LAW        optional folder whose files replace those of its effects/
% TEXT       what the run wrote about its grains: dumps, curves, and a
%            fingerprint of 15 digits; equal texts are equal grains
% FAULT      '' or the error message of the run
%
% See also: benchNames
function [text, fault] = benchTrial (model, variables, law)
  root = fileparts (fileparts (mfilename ('fullpath')));
  folder = tempname ();
  source = fullfile (root, 'DEMmodels', model);
  if ~isfolder (source)
    source = model;
  end
  system (sprintf ('cp -rL "%s" "%s"', source, folder));
  tidy = onCleanup (@() system (sprintf ('rm -rf "%s"', folder)));
  if nargin > 2
    system (sprintf ('cp "%s"/*.inc "%s"/*.head "%s"/effects/', law, law, ...
                     folder));
  end
  fid = fopen (fullfile (folder, 'data.head'), 'a');
  for name = fieldnames (variables).'
    fprintf (fid, "variable %s equal %.17g\n", name{1}, variables.(name{1}));
  end
  fclose (fid);
  system (sprintf (['cd "%s" && export OMPI_MCA_pml=ob1 ' ...
                    'OMPI_MCA_ess_singleton_isolated=1 ' ...
                    'OMPI_MCA_btl=self,vader && ' ...
                    'bash runscript > out 2> err < /dev/null'], folder));
  [~, text] = system (sprintf (['cd "%s" && cat output_checks.csv ' ...
                                '$(ls *.dump flow.csv spread.csv ' ...
                                'shear?.csv 2> /dev/null | sort) ' ...
                                '2> /dev/null'], folder));
  said = fileread (fullfile (folder, 'out'));
  fault = '';
  if isempty (strfind (said, 'RUN COMPLETE'))
    fault = said(max (1, end - 400):end);
  end
end

% SPDX-License-Identifier: GPL-3.0-only
