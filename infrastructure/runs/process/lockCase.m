% LOCKCASE  Keeps a second Octave out of a case folder.
%
% CALL: LOCK = lockCase (FOLDER)
%       LOCK = lockCase (FOLDER, NAME, NOTE)
%
%   FOLDER  case folder (text)
%   NAME    file of the lock in it (default 'decalioc.lock')
%   NOTE    what it is for (text, further lines of the lock; default '')
%   LOCK    onCleanup object; the folder is free again when it is cleared
%
% The lock is a file in FOLDER, which names host, process, its start, boot,
% command and PID namespace. A lock whose process is gone for sure (lockHolder)
% is taken over, and so is an empty one.
% Not flock, as in tools/lint.sh: Octave would need a helper to hold it, whose
% pipe the runs inherit; those outlive a kill -9 and would keep the case locked.
%
% Errors: DEcalioc:lockCase:inUse, DEcalioc:lockCase:cannotWrite,
% DEcalioc:lockCase:noLinks

function lock = lockCase (folder, name, note)
  if nargin < 2
    name = 'decalioc.lock';
  end
  if nargin < 3
    note = '';
  end
  file = fullfile (folder, name);
  draft = draftName (file);
  [~, mark] = processStart (getpid ());
  text = strtrim (sprintf ("%s %d %s\n%s", gethostname (), getpid (), mark, ...
                           note));
  try
    writeAtomic (draft, [text, "\n"], false);
  catch
    error ('DEcalioc:lockCase:cannotWrite', ...
           ['lockCase: the case folder %s must be writable: runs and ' ...
            'results are kept there. Copy the case to a folder of yours.'], ...
           folder);
  end
  tidy = onCleanup (@() forget (draft));
  cause = '';
  for attempt = 1:10
    [status, why] = link (draft, file);
    if status == 0
      lock = onCleanup (@() release (folder, name, text));
      if nargin < 2                        % that of a case, for a whole start
        tidyDrafts (folder);
        tidyDrafts (fullfile (folder, 'results'));
      end
      return
    end
    holder = lockHolder (folder, name);
    if strcmp (holder.state, 'none')
      cause = why;
    else
      takeOver (file, draft, holder);
    end
  end
  if isfolder (file)
    error ('DEcalioc:lockCase:cannotWrite', ...
           ['lockCase: %s must be a file that DEcalioc writes, got a folder. Take it ' ...
            'away, or give it another name.'], file);
  elseif ~isempty (cause)
    error ('DEcalioc:lockCase:noLinks', ...
           ['lockCase: the case folder %s must be on a file system with ' ...
            'hard links, which keep a second start out; making one gave: ' ...
            '%s. Move the case to another disk.'], folder, cause);
  end
  error ('DEcalioc:lockCase:inUse', ...
         ['lockCase: %s changes all the time; try again, and delete it if ' ...
          'no DEcalioc works in that folder for sure.'], file);
end

function takeOver (file, draft, holder)
  folder = fileparts (file);
  if ~strcmp (holder.state, 'gone')
    error ('DEcalioc:lockCase:inUse', ...
           ['lockCase: another DEcalioc works in %s (process %s on %s%s). ' ...
            'Wait for it or use a case folder of its own. If that process ' ...
            'is gone for sure (a container that was removed, a machine that ' ...
            'was restarted), take the lock away: rm %s'], folder, ...
           merge (isnan (holder.pid), 'without a number', sprintf ('%d', holder.pid)), ...
           holder.host, ...
           merge (strcmp (holder.state, 'unknown'), ...
                  ', which cannot be seen from here', ''), shellQuote (file));
  end
  % only one of two that see the same stale lock may take it away
  aside = draftName (file);
  if rename (file, aside) == 0
    [~, name, ending] = fileparts (aside);
    if ~strcmp (lockHolder (folder, [name, ending]).text, holder.text)
      link (aside, file);
    end
    forget (aside);
  end
end

function release (folder, name, text)
  if strcmp (lockHolder (folder, name).text, text)
    forget (fullfile (folder, name));
  end
end

function forget (file)
  [~, ~] = unlink (file);
end

%!test
%! folder = emptyFolder ();
%! file = fullfile (folder, 'decalioc.lock');
%! lock = lockCase (folder);
%! assert (isfile (file));
%! try
%!   lockCase (folder);
%! catch err
%! end
%! assert (err.identifier, 'DEcalioc:lockCase:inUse');
%! clear lock
%! assert (! isfile (file));
%! % the process of this lock is gone; process 1 started at another time; what a
%! % power cut has left shut the case for ever
%! [~, mark] = processStart (getpid ());
%! mark = strjoin ([{gethostname(), '1', '12345678901'}, ...
%!                  strsplit(mark, ' ')(2:end)], ' ');
%! for text = {[mark, "\n"], ''}
%!   writeAtomic (file, text{1});
%!   lock = lockCase (folder);
%!   mine = sprintf ('%s %d ', gethostname (), getpid ());
%!   assert (strncmp (fileread (file), mine, numel (mine)));
%!   clear lock
%! end
%! assert (numel (glob (fullfile (folder, '*'))), 0);
%!error id=DEcalioc:lockCase:cannotWrite lockCase ('/proc')

% SPDX-License-Identifier: GPL-3.0-only
