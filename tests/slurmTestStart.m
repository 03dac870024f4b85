% SLURMTESTSTART  Starts slurmTestPlan in an Octave of its own.
%
% CALL: PID = slurmTestStart (FOLDER, A, SECONDS)
%
%   arguments as in slurmTestCase
%   PID   process number of that Octave
%
% See also: slurmTestPlan

function pid = slurmTestStart (folder, a, seconds)
  root = fileparts (fileparts (mfilename ('fullpath')));
  text = sprintf (['history_save (false); addpath (''%s'', ''%s''); ' ...
                   'startToolbox (''%s''); ' ...
                   'slurmTestPlan (''%s'', %s, %g);'], ...
                  fullfile (root, 'tests'), ...
                  fullfile (root, 'infrastructure'), root, ...
                  strrep (folder, '''', ''''''), mat2str (a), seconds);
  pid = system (['exec octave-cli --no-init-file --eval ', ...
                 shellQuote(text), ' > /dev/null 2>&1'], false, 'async');
end
