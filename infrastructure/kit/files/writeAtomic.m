% WRITEATOMIC  Writes a text file so that it is there whole or not at all.
%
% CALL: writeAtomic (FILE, TEXT)
%       writeAtomic (FILE, TEXT, false)
%
%   FILE  path of the file (text); an older file of that name is replaced
%   TEXT  content (char)
%
% The text goes to a file beside it first, which then takes the name. It is on
% the disk before, so that a power cut leaves the old file or the new one; with
% false it is not waited for (11 ms): for files of a run, whose worth is told by
% their checksums and by end.mark (see guard.sh).
%
% Errors: DEcalioc:writeAtomic:cannotWrite (full disk, read-only folder)

function writeAtomic (file, text, isKept)
  draft = draftName (file);
  [fid, why] = fopen (draft, 'w');
  if fid < 0
    refuse (file, why);
  end
  fwrite (fid, text);
  fclose (fid);
  % neither of them, nor fflush, says that a short text met a full disk
  done = stat (draft).size == numel (text);
  if done && (nargin < 3 || isKept)
    done = isOnDisk (draft);
  end
  if ~done
    [~, ~] = unlink (draft);
    refuse (file, 'the text could not be written, the disk may be full');
  end
  [err, why] = rename (draft, file);
  if err ~= 0
    [~, ~] = unlink (draft);
    refuse (file, why);
  end
end

% Some file systems cannot sync a folder; only what loses data counts.
function yes = isOnDisk (draft)
  folder = fileparts (make_absolute_filename (draft));
  [~, output] = system (['LC_ALL=C sync -- ', shellQuote(draft), ' ', ...
                         shellQuote(folder), ' 2>&1']);
  yes = isempty (regexp (output, 'No space|quota|nput/output error', 'once'));
end

function refuse (file, why)
  error ('DEcalioc:writeAtomic:cannotWrite', ...
         ['writeAtomic: %s must be writable, got: %s. Free some space or ' ...
          'correct the permissions and start again; finished runs are ' ...
          'kept.'], file, why);
end

%!test
%! file = tempname ();
%! writeAtomic (file, "one\ntwo\n");
%! assert (fileread (file), "one\ntwo\n");
%! writeAtomic (file, 'three');
%! assert (fileread (file), 'three');
%! assert (isempty (glob ([file, '.*'])));
%! % a link that bears its name is replaced, not followed
%! other = tempname ();
%! writeAtomic (other, 'precious');
%! link = tempname ();
%! symlink (other, link);
%! writeAtomic (link, 'mine');
%! assert ({fileread(other), fileread(link)}, {'precious', 'mine'});
%!error id=DEcalioc:writeAtomic:cannotWrite writeAtomic ('/nowhere/x', 'a')

% SPDX-License-Identifier: GPL-3.0-only
