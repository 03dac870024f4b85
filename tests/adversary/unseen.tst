% A process that cannot be seen from here (another container: a PID namespace of
% the same machine and host name; a /proc that hides it) is not gone.

%!function yes = canUnshare ()
%!  yes = system ('unshare -p -f --mount-proc true > /dev/null 2>&1') == 0;
%!endfunction
%!testif ; canUnshare ()
%! folder = tempname ();
%! mkdir (folder);
%! root = fileparts (fileparts (which ('startToolbox')));
%! paths = strjoin (cellfun (@(f) ['--path ', f], fullfile ...
%!          (root, 'infrastructure', {'runs/process', 'kit/files', 'kit/text', ...
%!                                    'kit/fields'}), ...
%!                           'UniformOutput', false), ' ');
%! inside = @(words, code) system (sprintf (['unshare %s octave-cli --norc ', ...
%!           '--quiet %s --eval "%s" > %s/out 2>&1'], words, paths, code, ...
%!           folder));
%! % a lock from a container whose process is alive, here and in another one
%! take = sprintf (['lock = lockCase (''%s''); fclose (fopen (''%s/on'', ', ...
%!                  '''w'')); pause (60);'], folder, folder);
%! system (sprintf (['unshare -p -f --kill-child --mount-proc octave-cli ', ...
%!                   '--norc --quiet %s --eval "%s" > /dev/null 2>&1 & ', ...
%!                   'echo $! > %s/number'], paths, take, folder));
%! waitUntil (@() isfile (fullfile (folder, 'on')));
%! assert (lockHolder (folder).state, 'unknown');
%! inside ('-p -f --mount-proc', sprintf ('lockCase (''%s'');', folder));
%! text = fileread (fullfile (folder, 'out'));
%! assert (~isempty (strfind (text, 'cannot be seen from here')), text);
%! assert (~isempty (strfind (text, 'rm ''/')), text);
%! kill (str2double (fileread (fullfile (folder, 'number'))), 9);
%! % the container is gone: nobody can say so, and the cure is that of the text
%! assert (lockHolder (folder).state, 'unknown');
%! unlink (fullfile (folder, 'decalioc.lock'));
%! % this process, as one in a namespace with the /proc of another sees it
%! lock = lockCase (folder);
%! inside ('-p -f', sprintf ('disp (lockHolder (''%s'').state)', folder));
%! assert (strtrim (fileread (fullfile (folder, 'out'))), 'unknown');

% SPDX-License-Identifier: GPL-3.0-only
