% SAYMACHINE  Says which system this is, and what disk and memory it has.
%
% CALL: sayMachine (FOLDER, LINE)
%
%   FOLDER  folder in which a case would lie (text): its disk counts
%   LINE    handle LINE (NAME, TEXT) that writes one line
%
% On a system that keeps one of these elsewhere, the line says 'not known'.

function sayMachine (folder, line)
  [~, name] = system ('. /etc/os-release 2> /dev/null && echo "$PRETTY_NAME"');
  [~, kernel] = system ('uname -srm');
  name = strtrim (name);
  line ('system', [name, repmat(', ', 1, ~isempty (name)), strtrim(kernel)]);
  line ('memory', memoryText ());
  line ('disk', diskText (folder));
end

% A container may have less than its machine.
function text = memoryText ()
  text = 'not known';
  kib = regexp (readText ('/proc/meminfo'), ...
                '^Mem(?:Total|Available):\s+(\d+)', 'tokens', 'lineanchors');
  if numel (kib) == 2
    bytes = 1024 * str2double ([kib{:}]);
    text = sprintf ('%.1f GiB, %.1f GiB of it free', bytes / 2^30);
  end
  most = str2double (readText ('/sys/fs/cgroup/memory.max'));   % NaN: 'max'
  if isfinite (most)
    text = sprintf ('%s; this container may use %.1f GiB', text, most / 2^30);
  end
end

function text = diskText (folder)
  text = 'not known';
  [status, said] = system (['LC_ALL=C df -Pk -- ', shellQuote(folder), ...
                            ' 2> /dev/null']);
  kib = regexp (said, '\s(\d+)\s+\d+\s+(\d+)\s+\d+%', 'tokens', 'once');
  if status == 0 && ~isempty (kib)
    text = sprintf ('%.1f GiB free of %.1f GiB at %s', ...
                    str2double (kib([2, 1])) / 2^20, folder);
  end
end

%!function [names, texts] = said (folder)
%!  text = evalc ('sayMachine (folder, @(n, t) printf (''%s: %s\n'', n, t))');
%!  parts = regexp (text, '^(\w+): (.*)$', 'tokens', 'lineanchors', ...
%!                  'dotexceptnewline');
%!  parts = vertcat (parts{:});
%!  [names, texts] = deal (parts(:, 1)', parts(:, 2)');
%!endfunction
%!test
%! [names, texts] = said (tempdir ());
%! assert (names, {'system', 'memory', 'disk'});
%! assert (~isempty (strfind (texts{1}, strtrim (nthargout (2, @system, ...
%!                                                         'uname -m')))));
%! [~, free] = system (['LC_ALL=C df -Pk ', tempdir(), ...
%!                      ' | awk ''END { print $4 / 2^20 }''']);
%! assert (sscanf (texts{3}, '%g'), str2double (free), 1);
%!test
%! [~, texts] = said ('/nowhere/at all');
%! assert (texts{3}, 'not known');

% SPDX-License-Identifier: GPL-3.0-only
