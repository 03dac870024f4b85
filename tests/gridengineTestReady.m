% GRIDENGINETESTREADY  Says whether a test cluster can be started here.
%
% CALL: READY = gridengineTestReady ()
%
%   READY  logical; false, and a line on stdout that says why, where Grid Engine
%          is not installed, this is not root, or the daemons do not start. With
%          CI=true in the environment the last is not tried: there it is a
%          failure of the tests
%
% See also: gridengineTestUp

function ready = gridengineTestReady ()
  programs = {'sge_qmaster', 'sge_execd', 'qsub'};
  isThere = @(p) isfile (fullfile ('/usr/lib/gridengine', p));
  why = '';
  if ~all (cellfun (isThere, programs))
    why = 'apt-get install gridengine-master gridengine-exec gridengine-client';
  elseif getuid () ~= 0
    why = 'a test cluster can be started by root only';
  elseif isempty (getenv ('CI'))
    try
      tidy = gridengineTestUp (1);
    catch
      why = 'its daemons do not come up on this machine';
    end
  end
  ready = isempty (why);
  if ~ready
    printf ('tests with Grid Engine are skipped: %s\n', why);
  end
end
