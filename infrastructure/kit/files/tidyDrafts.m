% TIDYDRAFTS  Removes drafts that programs which were killed have left.
%
% CALL: tidyDrafts (FOLDER, AGE, NAME)
%
%   FOLDER  text; may be missing
%   AGE     least age of what is removed (s; default one hour: a draft is
%           written within seconds)
%   NAME    of the file whose drafts are meant (text; default: all)
%
% See also: draftName

function tidyDrafts (folder, age, name)
  if nargin < 2
    age = 3600;
  end
  ofFile = '';
  if nargin > 2
    ofFile = ['^', regexptranslate('escape', name)];
  end
  names = readdir (folder);
  isDraft = ~cellfun ('isempty', regexp (names, [ofFile, '\.([0-9a-f]{24}|' ...
                                                 'mark\.\d+\.\d+)\.tmp$'], ...
                                         'once'));
  for draft = reshape (names(isDraft), 1, [])
    file = fullfile (folder, draft{1});
    info = lstat (file);
    if ~isempty (info) && time () - info.mtime > age
      [~, ~] = unlink (file);
    end
  end
end

%!test
%! folder = emptyFolder ();
%! file = fullfile (folder, 'a');
%! for name = {file, [file, '.tmp'], draftName(file), [folder, ...
%!                                       '/end.mark.12.345.tmp']}
%!   fclose (fopen (name{1}, 'w'));
%! end
%! tidyDrafts (folder);
%! assert (numel (readdir (folder)), 6);
%! tidyDrafts (folder, -1, 'b');
%! assert (numel (readdir (folder)), 6);
%! tidyDrafts (folder, -1);
%! assert (readdir (folder), {'.'; '..'; 'a'; 'a.tmp'});
%! tidyDrafts ('/no/such/folder');

% SPDX-License-Identifier: GPL-3.0-only
