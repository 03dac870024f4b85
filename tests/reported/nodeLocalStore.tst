% A store on /tmp, and a queue whose other nodes have a /tmp of their own.

%!test
%! folder = reportedCase ('nodeLocalStore');
%! before = getenv ('DECALIOC_STORE');
%! back = onCleanup (@() setenv ('DECALIOC_STORE', before));
%! for place = {'/tmp/store', '/dev/shm/store', '/var/tmp'}
%!   setenv ('DECALIOC_STORE', place{1});
%!   [status, out] = startCommand (folder, 'check --dry-run');
%!   assert (status == 0, out);
%!   assert (! isempty (regexp (out, ['WARNING +the runs go to ', place{1}])), out);
%! end
%! % runs of this machine alone may lie there
%! file = fullfile (folder, 'loadInput.m');
%! writeAtomic (file, strrep (fileread (file), '''slurm''', '''local'''));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0 && isempty (strfind (out, 'the runs go to')), out);

% SPDX-License-Identifier: GPL-3.0-only
