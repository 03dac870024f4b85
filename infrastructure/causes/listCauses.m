% LISTCAUSES  All causes that a person may ask for.
%
% CALL: CAUSES = listCauses ()
%       CAUSES = listCauses (FOLDERS)
%
%   FOLDERS  text or cell of folders that are looked in first, for instance the
%            causes/ folder of a case; the toolbox's library comes last
%   CAUSES   1 x n struct of describeCause, sorted by name; of causeMoisture.m
%            'moisture'; the first folder that has a name counts
%
% See also: describeCause, weighCauses

function causes = listCauses (folders)
  if nargin < 1
    folders = {};
  end
  folders = [cellstr(folders)(:).', {fileparts(mfilename ('fullpath'))}];
  causes = [];
  known = {};
  for k = 1:numel (folders)
    found = regexp ({dir(fullfile (folders{k}, 'cause*.m')).name}, ...
                    '^cause[A-Z]\w*(?=\.m$)', 'match', 'once');
    found = setdiff (found(~cellfun (@isempty, found)), known);
    known = [known, found];
    causes = [causes, cellfun(@(name) ofFile (folders{k}, name), found)];
  end
  [~, order] = sort ({causes.name});
  causes = causes(order);
end

function cause = ofFile (folder, name)
  if ~any (strcmp (strsplit (path (), pathsep ()), folder))
    addpath (folder);
    restore = onCleanup (@() rmpath (folder));
  end
  cause = feval (name);
end

%!test
%! names = {listCauses().name};
%! assert (issorted (names));
%! assert (all (ismember ({'moisture', 'lining', 'fines', 'refill', 'batch', ...
%!                         'instrument'}, names)));

%!test % a case's own file comes first
%! folder = emptyFolder ();
%! file = fullfile (folder, 'causeTrialOfListCauses.m');
%! writeAtomic (file, ["function c = causeTrialOfListCauses ()\n", ...
%!   "c = describeCause (struct ('name', 'aaa', 'label', 'l', ", ...
%!   "'question', 'q', 'members', {{{'tilt'}, '', 0, 1}}));\nend\n"]);
%! causes = listCauses (folder);
%! unlink (file);
%! rmdir (folder);
%! assert (causes(1).name, 'aaa');
