% WRITESET  Writes the parameter set of a run into its folder.
%
% CALL: writeSet (FOLDER, PARAMS, PLANROW)
%
% FOLDER   folder of the run (text)
% PARAMS   1 x d, written to params.csv with 15 digits (toDigits)
% PLANROW  row of the plan, written to ExPlan.txt; 0 = no run of the plan, no
%          such file

function writeSet (folder, params, planRow)
  writeAtomic (fullfile (folder, 'params.csv'), ...
               [sprintf('%.15g,', params)(1:end - 1), "\n"], false);
  if planRow ~= 0
    writeAtomic (fullfile (folder, 'ExPlan.txt'), sprintf ("%d\n", planRow), ...
                 false);
  end
end

%!test
%! folder = emptyFolder ();
%! writeSet (folder, [0.1, 1/3], 0);
%! assert (csvread (fullfile (folder, 'params.csv')), toDigits ([0.1, 1/3]));
%! assert (! isfile (fullfile (folder, 'ExPlan.txt')));

% SPDX-License-Identifier: GPL-3.0-only
