% DRAFTNAME  Name of a draft beside a file, which nobody can foresee.
%
% CALL: DRAFT = draftName (FILE)
%
%   FILE   path of the file that the draft becomes (text)
%   DRAFT  path beside it: FILE, a dot, 24 random hexadecimal digits and .tmp
%
% Who may write to a folder that several users share could put a link in the
% place of a draft whose name he knows: what is written then ends in another
% file. tidyDrafts removes what killed programs leave.

function draft = draftName (file)
  fid = fopen ('/dev/urandom', 'r');        % rand would repeat with its seed
  bytes = fread (fid, [1, 12], 'uint8');
  fclose (fid);
  draft = sprintf ('%s.%s.tmp', file, sprintf ('%02x', bytes));
end

%!assert (regexp (draftName ('/a/b'), '^/a/b\.[0-9a-f]{24}\.tmp$'), 1)
%!assert (! strcmp (draftName ('a'), draftName ('a')))

% SPDX-License-Identifier: GPL-3.0-only
