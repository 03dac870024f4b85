% LOCKCASE  Keeps a second Octave out of a case folder.
%
% CALL: LOCK = lockCase (FOLDER)
%
%   FOLDER  case folder (text)
%   LOCK    onCleanup object; the folder is free again when it is cleared
%
% The lock is the file decalioc.lock in FOLDER, which names host, process and
% the start of that process. A lock whose process is gone is taken over.
% Not flock, as in tools/lint.sh: Octave would need a helper to hold it, whose
% pipe the runs inherit; those outlive a kill -9 and would keep the case locked.
%
% Errors: DEcalioc:lockCase:inUse, DEcalioc:lockCase:cannotWrite,
% DEcalioc:lockCase:noLinks
%
% See also: DEcalioc

function lock = lockCase (folder)
  file = fullfile (folder, 'decalioc.lock');
  draft = sprintf ('%s.%d', file, getpid ());
  try
    writeAtomic (draft, [identity(getpid ()), "\n"]);
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
      lock = onCleanup (@() release (file, getpid ()));
      return
    end
    if isempty (readLock (file)) && ~isfile (file)
      cause = why;
    end
    takeOver (file, draft, folder);
  end
  if ~isempty (cause)
    error ('DEcalioc:lockCase:noLinks', ...
           ['lockCase: the case folder %s must be on a file system with ' ...
            'hard links, which keep a second start out; making one gave: ' ...
            '%s. Move the case to another disk.'], folder, cause);
  end
  error ('DEcalioc:lockCase:inUse', ...
         'lockCase: %s changes all the time; try again.', file);
end

function takeOver (file, draft, folder)
  holder = readLock (file);
  if isempty (holder)
    return
  end
  [host, rest] = strtok (holder);
  pid = sscanf (rest, '%d', 1);
  isHere = strcmp (host, gethostname ());
  if ~isHere || strcmp (identity (pid), holder)
    error ('DEcalioc:lockCase:inUse', ...
           ['lockCase: another DEcalioc works in %s (process %d on %s). ' ...
            'Wait for it or use a case folder of its own. If that process ' ...
            'is gone for sure, delete %s.'], folder, pid, host, file);
  end
  % only one of two that see the same stale lock may take it away
  aside = [draft, '.stale'];
  if rename (file, aside) == 0
    if ~strcmp (readLock (aside), holder)
      link (aside, file);
    end
    forget (aside);
  end
end

function text = identity (pid)
  start = processStart (pid);
  if isempty (start)
    start = 'gone';
  end
  text = sprintf ('%s %d %s', gethostname (), pid, start);
end

function text = readLock (file)
  text = '';
  fid = fopen (file, 'r');
  if fid >= 0
    text = strtrim (fread (fid, Inf, 'uint8=>char')');
    fclose (fid);
  end
end

function release (file, pid)
  if strcmp (readLock (file), identity (pid))
    forget (file);
  end
end

function forget (file)
  [~, ~] = unlink (file);
end

%!test
%! folder = tempname ();
%! mkdir (folder);
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
%! % the process of this lock is gone; process 1 started at another time
%! writeAtomic (file, sprintf ("%s 1 12345678901\n", gethostname ()));
%! lock = lockCase (folder);
%! assert (isempty (strfind (fileread (file), '12345678901')));
%! clear lock
%! assert (numel (glob (fullfile (folder, '*'))), 0);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%!error id=DEcalioc:lockCase:cannotWrite lockCase ('/proc')
