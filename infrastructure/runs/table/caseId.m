% CASEID  Which case a folder is, wherever it stands.
%
% CALL: ID = caseId (FOLDER)
%       ID = caseId (FOLDER, true)    makes one where there is none yet
%
%   FOLDER  case folder (text)
%   ID      32 hexadecimal digits, drawn at the first start and kept in its file
%           decalioc.id; '' where there is none, or none of its own
%
% The path does not tell: in containers all cases are /case. The file holds the
% id and its own number on the disk (inode). A folder that was moved or is
% mounted elsewhere keeps it; of a copy the number is another, so a copy is a
% case of its own from its next start on. Moved to another disk or restored, a
% folder is a copy, too, unless the number is taken out of the file.

function id = caseId (folder, isMade)
  file = fullfile (folder, 'decalioc.id');
  id = idIn (file);
  if isempty (id) && nargin > 1 && isMade
    makeId (file);
    id = idIn (file);
  end
end

function id = idIn (file)
  id = '';
  s = stat (file);
  parts = regexp (checkReadText (file), '^([0-9a-f]{32})( \d+)?\s*$', ...
                  'tokens', 'once');
  if ~isempty (parts) && ~isempty (s) && ...
     (isscalar (parts) || str2double (parts{2}) == s.ino)
    id = parts{1};
  end
end

% By the one process that holds the lock of the case (runJobs).
function makeId (file)
  fid = fopen ('/dev/urandom', 'r');
  id = sprintf ('%02x', fread (fid, 16));
  fclose (fid);
  draft = [file, '.', id];
  fid = fopen (draft, 'w');
  if fid < 0
    return                              % lockCase says that it cannot be written
  end
  fprintf (fid, "%s %d\n", id, stat (draft).ino);
  fclose (fid);
  if ~isempty (lstat (file))
    [~, ~] = rename (file, [draft, '.old']);      % that of a copy
    [~, ~] = unlink ([draft, '.old']);
  end
  [~, ~] = link (draft, file);
  [~, ~] = unlink (draft);
end

%!test
%! folder = emptyFolder ();
%! assert (caseId (folder), '');
%! id = caseId (folder, true);
%! assert (numel (id), 32);
%! assert ({caseId(folder), caseId(folder, true)}, {id, id});
%! assert (numel (readdir (folder)), 3);
%! % moved; copied, also as it was; a backup that is said to be the case itself
%! moved = tempname ();
%! rename (folder, moved);
%! assert (caseId (moved), id);
%! system (['cp -a ', moved, ' ', folder]);
%! assert (caseId (folder), '');
%! other = caseId (folder, true);
%! assert ({numel(other), strcmp(other, id), caseId(moved)}, {32, false, id});
%! writeAtomic (fullfile (folder, 'decalioc.id'), [id, "\n"]);
%! assert (caseId (folder), id);
%! for text = {'', 'x', [id, ' 1'], [id, "\nls"], upper(id(1:31))}
%!   writeAtomic (fullfile (folder, 'decalioc.id'), text{1});
%!   assert (caseId (folder), '');
%! end
%! assert (caseId ('/nowhere', true), '');

% SPDX-License-Identifier: GPL-3.0-only
