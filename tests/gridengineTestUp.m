% GRIDENGINETESTUP  Starts a test cluster that goes down with this Octave.
%
% CALL: [TIDY, FOLDER] = gridengineTestUp (SLOTS)
%
%   SLOTS   slots that its only host pretends to have
%   TIDY    object that stops the cluster when it is cleared, and puts the
%           environment back
%   FOLDER  folder of the cluster (text)
%
% See also: gridengineTestReady, gridengine-up.sh

function [tidy, folder] = gridengineTestUp (slots)
  folder = tempname (P_tmpdir (), 'sge-');
  here = fileparts (mfilename ('fullpath'));
  up = fullfile (here, 'gridengine-up.sh');
  command = sprintf (['export GRIDENGINE_TEST_SLOTS=%d; %s %s %d 2>&1 && ', ...
                      '. %s/settings.sh && env | grep -E "^(SGE_|PATH=)"'], ...
                     slots, shellQuote (up), folder, ...
                     getpid (), folder);
  [status, text] = system (command);
  if status ~= 0
    error ('DEcalioc:gridengineTestUp:runFailed', ...
           'gridengineTestUp: the test cluster must start, got: %s', text);
  end
  path = getenv ('PATH');
  tidy = onCleanup (@() takeDown (here, folder, path));
  settings = regexp (text, '^(\w+)=(.*)$', 'tokens', 'lineanchors', ...
                     'dotexceptnewline');
  for k = 1:numel (settings)
    setenv (settings{k}{:});
  end
end

function takeDown (here, folder, path)
  system ([shellQuote(fullfile (here, 'gridengine-down.sh')), ' ', folder]);
  confirm_recursive_rmdir (false, 'local');
  rmdir (folder, 's');
  cellfun (@unsetenv, {'SGE_ROOT', 'SGE_CELL', 'SGE_QMASTER_PORT', ...
                       'SGE_EXECD_PORT'});
  setenv ('PATH', path);
end
