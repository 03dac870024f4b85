% LOCKHOLDER  Which process works in a case folder, as its lock says.
%
% CALL: HOLDER = lockHolder (FOLDER, NAME)
%
%   FOLDER  case folder (text)
%   NAME    file of the lock in it (default 'decalioc.lock')
%   HOLDER  scalar struct: text (of the lock), host ('' where there is no
%           lock), pid, state:
%           'none'; 'alive' (host, process, its start, boot and command agree);
%           'gone' (the lock is what a killed Octave or a power cut has left);
%           'unknown' (it cannot be seen from here: another host, another
%           container, a hidden process; or the lock does not note all
%           that). note (further lines of the lock; '')
%
% Gone is only what the same boot and PID namespace do not show, and what ran
% outside of containers before the last boot. A lock takes its name when it is
% whole, so an empty one is nobody's.

function holder = lockHolder (folder, name)
  if nargin < 2
    name = 'decalioc.lock';
  end
  holder = struct ('text', '', 'host', '', 'pid', NaN, 'state', 'none', ...
                   'note', '');
  fid = fopen (fullfile (folder, name), 'r');
  if fid < 0
    return
  end
  text = fread (fid, Inf, 'uint8=>char')';
  fclose (fid);
  holder.text = strtrim (text(text ~= 0));
  lines = strsplit (asUtf8 (holder.text), "\n");
  holder.note = strtrim (strjoin (lines(2:end), "\n"));
  words = strsplit (lines{1}, ' ');
  holder.host = words{1};
  holder.pid = str2double ([words, {''}]{2});
  holder.state = 'unknown';
  if isempty (holder.text)
    holder.state = 'gone';
  elseif strcmp (holder.host, gethostname ()) && ~isnan (holder.pid)
    holder.state = stateOf (holder.pid, words(3:end));
  end
end

% MARK  words of processStart: start, boot, command, namespace
function state = stateOf (pid, mark)
  [~, now, isSure] = processStart (pid);
  [~, own] = processStart (getpid ());
  [now, own] = deal (ostrsplit (now, ' '), ostrsplit (own, ' '));
  n = numel (mark);
  isSame = @(k) n == 4 && numel (own) == 4 && strcmp (mark{k}, own{k});
  state = 'unknown';
  if n == 4 && isequal (mark, now)
    state = 'alive';
  elseif isSame (4) && isSame (2) && isSure
    state = 'gone';
  elseif isSame (4) && ~isSame (2) && strcmp (mark{4}, '4026531836')
    state = 'gone';         % PROC_PID_INIT_INO: no container, before a restart
  end
end

%!test
%! folder = emptyFolder ();
%! assert (lockHolder (folder).state, 'none');
%! lock = lockCase (folder);
%! holder = lockHolder (folder);
%! assert ({holder.state, holder.pid}, {'alive', getpid()});
%! text = holder.text;
%! clear lock
%! file = fullfile (folder, 'decalioc.lock');
%! words = strsplit (text, ' ');
%! first = '4026531836';                    % that of a machine, see proc_ns.h
%! boot = fliplr (words{4});
%! after = {'unknown', 'gone'}{1 + strcmp(words{6}, first)};
%! with = @(k, word) strjoin ([words(1:k - 1), {word}, words(k + 1:end)], ' ');
%! % before a restart, in a container before one, in another container, another
%! % program, no namespace, less, rubbish, cut power
%! for given = {with(4, boot), after; ...
%!              strrep(with(4, boot), words{6}, '77'), 'unknown'; ...
%!              with(6, '77'), 'unknown'; with(6, '-'), 'unknown'; ...
%!              strrep(text, 'octave', 'mail'), 'gone'; ...
%!              strjoin(words(1:5), ' '), 'unknown'; ...
%!              strjoin([words(1:4), {'mail'}], ' '), 'unknown'; ...
%!              strjoin([words(1:2), {'12345678901'}], ' '), 'unknown'; ...
%!              strjoin(words(1:3), ' '), 'unknown'; ...
%!              'elsewhere 1 12345678901', 'unknown'; 'rubbish', 'unknown'; ...
%!              sprintf("%s\nof a case\n", text), 'alive'; ...
%!              '', 'gone'; char(zeros (1, 40)), 'gone'}'
%!   writeAtomic (file, given{1});
%!   assert (strcmp (lockHolder (folder).state, given{2}), given{1});
%! end

% SPDX-License-Identifier: GPL-3.0-only
