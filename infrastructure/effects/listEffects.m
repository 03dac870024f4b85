% LISTEFFECTS  Names all effects of the library.
%
% CALL: [NAMES, FILES] = listEffects ()
%       [NAMES, FILES] = listEffects (FOLDERS)
%
% FOLDERS  text or cell of folders that are looked in first, for instance the
%          effects/ folder of a case; the toolbox's library comes last
% NAMES    1 x n cell, sorted: effectCohesion.m is 'cohesion'
% FILES    1 x n cell of full file names; the first folder that has a name
%          counts
%
% See also: getEffect, resolveEffects
function [names, files] = listEffects (folders)
  if nargin < 1
    folders = {};
  end
  folders = [cellstr(folders)(:).', {fileparts(mfilename ('fullpath'))}];
  names = {};
  files = {};
  for k = 1:numel (folders)
    found = dir (fullfile (folders{k}, 'effect*.m'));
    for file = {found.name}
      word = regexp (file{1}, '^effect([A-Z]\w*)\.m$', 'tokens', 'once');
      if ~isempty (word)
        names{end + 1} = [lower(word{1}(1)), word{1}(2:end)];
        files{end + 1} = fullfile (folders{k}, file{1});
      end
    end
  end
  [names, first] = unique (names, 'first');
  files = files(first);
end

%!test % sorted, no helper function among them
%! names = listEffects ();
%! assert (issorted (names));
%! assert (any (strcmp (names, 'cohesion')));
%! assert (~any (strcmp (names, 'sOfModel')));

%!test % a case's own file comes first
%! folder = emptyFolder ();
%! file = fullfile (folder, 'effectCohesion.m');
%! fclose (fopen (file, 'w'));
%! [names, files] = listEffects (folder);
%! own = files{strcmp(names, 'cohesion')};
%! delete (file);
%! rmdir (folder);
%! assert (own, file);
