% LISTCAUSES  All causes that a person may ask for.
%
% CALL: CAUSES = listCauses ()
%       CAUSES = listCauses (FOLDERS)
%
%   FOLDERS  text or cell of folders that are looked in first, for instance that
%            of a case and its causes/; the toolbox's library comes last
%   CAUSES   1 x n struct of describeCause, sorted by name; of causes.csv, a row a
%            member, the first of a cause with its texts, or of causeSpill.m
%            'spill'; the first folder that has a name counts
%
% Errors: DEcalioc:listCauses:badTable
%
% See also: describeCause, weighCauses

function causes = listCauses (folders)
  if nargin < 1
    folders = {};
  end
  causes = [];
  for folder = cellstr (folders)(:).'
    causes = [causes, ofFunctions(folder{1}), ...
              ofTable(fullfile (folder{1}, 'causes.csv'))];
  end
  library = fileparts (mfilename ('fullpath'));
  causes = [causes, ofTable(fullfile (library, 'causes.csv'))];
  [~, first] = unique ({causes.name}, 'first');
  causes = causes(first);
end

function causes = ofFunctions (folder)
  causes = [];
  found = regexp ({dir(fullfile (folder, 'cause*.m')).name}, ...
                  '^cause[A-Z]\w*(?=\.m$)', 'match', 'once');
  for name = found(~cellfun (@isempty, found))
    causes = [causes, ofFunction(folder, name{1})];
  end
end

function cause = ofFunction (folder, name)
  if ~any (strcmp (strsplit (path (), pathsep ()), folder))
    addpath (folder);
    restore = onCleanup (@() rmpath (folder));
  end
  cause = feval (name);
end

function causes = ofTable (file)
  causes = [];
  if ~isfile (file)
    return
  end
  rows = tableRows (file);
  needed = {'cause', 'label', 'question', 'effects', 'share', 'spread'};
  if ~all (isfield (rows, needed)) || ...
     any (isnan (str2double ([{rows.share}, {rows.spread}])))
    error ('DEcalioc:listCauses:badTable', ...
           ['listCauses: %s must have the columns %s, the last two with a ' ...
            'number in each row. Take infrastructure/effects/causes.csv of ' ...
            'the toolbox as a pattern.'], file, strjoin (needed, ', '));
  end
  for name = unique ({rows.cause}, 'stable')
    causes = [causes, ofRows(rows(strcmp ({rows.cause}, name{1})))];
  end
end

% The first row of a cause tells of all of it, the others of their members.
function cause = ofRows (rows)
  first = rows(1);
  given = struct ('name', first.cause, 'label', first.label, ...
                  'question', first.question);
  groups = arrayfun (@(row) givenField (row, 'group', ''), rows(:), ...
                     'UniformOutput', false);
  given.members = [cellfun(@strsplit, {rows.effects}', ...
                           'UniformOutput', false), groups, ...
                   num2cell(str2double ([{rows.share}', {rows.spread}']))];
  given.oneOf = strcmp (givenField (first, 'oneOf', ''), 'yes');
  given.usually = givenField (first, 'usually', 'yes');
  given.source = givenField (first, 'source', '');
  cause = describeCause (given);
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

%!test % a table of the case: of two members; one without a share
%! folder = emptyFolder ();
%! file = fullfile (folder, 'causes.csv');
%! head = "cause,label,question,effects,share,spread\n";
%! writeAtomic (file, [head, "aab,l,q?,tilt,0,0.6\naab,,,gate liftSpeed,0.2,0.1\n"]);
%! causes = listCauses (folder);
%! assert ({causes(1).name, causes(1).members(2).effects}, ...
%!         {'aab', {'gate', 'liftSpeed'}});
%! assert ([causes(1).members.share], [0, 0.2]);
%! writeAtomic (file, [head, "aab,l,q?,tilt,,0.6\n"]);
%! fail ('listCauses (folder)', 'with a number in each row');
%! unlink (file);
%! rmdir (folder);

% SPDX-License-Identifier: GPL-3.0-only
