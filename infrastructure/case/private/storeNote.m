% STORENOTE  Warns of a store that only this machine sees, where a queue makes runs.
%
% CALL: TEXT = storeNote (STORE, EXECUTOR)
%
%   STORE     path of the store, there or not;  EXECUTOR  Input.executor (texts)
%   TEXT      a sentence without its full stop; '': nothing to warn of
%
% Folders for what is temporary (also by way of a link), those in memory, and those that
% are called local are each machine's own, unless a file system of the network lies there.

function text = storeNote (store, executor)
  text = '';
  if describeExecutor (executor).isHere
    return
  end
  there = store;
  while ~exist (there, 'file') && ~strcmp (there, fileparts (there))
    there = fileparts (there);
  end
  real = [canonicalize_file_name(there), ''];
  isTemporary = ~isempty (regexp ([real, '/'], '^/((var/)?tmp|dev/shm|run)/', 'once')) || ...
                ~isempty (regexp ([store, '/'], ['(?<!/usr)/(local|(l|local_?)scratch|' ...
                                                 'scratch_local|ramdisk)/'], 'once'));
  [~, kind] = system (['stat -f -c %T -- ', shellQuote(there), ' 2> /dev/null']);
  kind = strtrim (kind);
  network = {'nfs', 'nfs4', 'lustre', 'gpfs', 'beegfs', 'ceph', 'cifs', 'smb2', ...
             'afs', 'panfs', 'fuseblk', 'fuse'};
  isMemory = any (strcmp (kind, {'tmpfs', 'ramfs'}));
  if isMemory || isTemporary && ~any (strcmp (kind, network))
    text = sprintf (['the runs go to %s, which is on this machine alone: the other ' ...
                     'nodes of the queue (Input.executor = ''%s'') have a folder of ' ...
                     'that name of their own. Set Input.store or DECALIOC_STORE to ' ...
                     'one that all of them see'], store, executor);
  end
end

%!test
%! folder = emptyFolder ();
%! assert (storeNote (folder, 'local'), '');
%! for place = {'/tmp/a/b', '/var/tmp/x', '/dev/shm/store', '/scratch/local/me', '/lscratch/x'}
%!   note = storeNote (place{1}, 'slurm');
%!   assert (! isempty (strfind (note, place{1})), place{1});
%! end
%! assert (! isempty (storeNote ('/tmp/x', 'gridengine')));
%! for place = {'/usr/share', '/usr/local/store', '/home/me/localised', '/scratch/me'}
%!   assert (storeNote (place{1}, 'slurm'), '');
%! end
%! % by way of a link
%! place = fullfile (folder, 'link');
%! symlink ('/dev/shm', place);
%! assert (! isempty (storeNote (place, 'slurm')));

% SPDX-License-Identifier: GPL-3.0-only
