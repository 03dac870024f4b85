% AGEOFRESULTS  Says which results are older than the code that they depend on.
%
% CALL: LINES = ageOfResults (ROOT)
%
%   ROOT   folder of the toolbox, a clone
%   LINES  1 x n cell, for each room that has changed the results that are older, and
%          those of a commit that the clone does not hold; none where ROOT is no clone
%
% figures.csv names the rooms of each table of results, folders of infrastructure/;
% the commit is the oldest one of its first lines (originLines). A commit that changes
% remarks and tests alone changes no room, nor does one whose message has a line
% 'Results stay: ' and how that was seen.
%
% Errors: DEcalioc:ageOfResults:missingRoom (a room without its folder)
%
% See also: writeFigures

function lines = ageOfResults (root)
  place = fullfile (root, 'benchmarks', 'figures');
  rooms = {'diagnosis', 'calibration', 'surrogates', 'runs'};
  uses = tableRows (fullfile (place, 'figures.csv'));
  uses = uses(cellfun (@(c) isfile (fileOf (root, c)), {uses.csv}));
  lines = unknownOnes (root, {uses.csv});
  for room = rooms
    folder = fullfile ('infrastructure', room{1});
    if ~isfolder (fullfile (root, folder))
      error ('DEcalioc:ageOfResults:missingRoom', ...
             ['ageOfResults: the rooms that results depend on must be folders, got ', ...
              'no %s. Write here where it lies now.'], folder);
    end
    depends = cellfun (@(r) any (strcmp (strsplit (r, ' '), room{1})), {uses.rooms});
    last = gitLine (root, sprintf ('log -1 --format="%%h of %%as" %s -- %s', codeOnly (), ...
                                   folder));
    older = {};
    for csv = {uses(depends).csv}
      if ~isempty (last) && isOlder (root, originOf (fileOf (root, csv{1})).commit, ...
                                     folder)
        older(end + 1) = csv;
      end
    end
    if ~isempty (older)
      lines{end + 1} = sprintf ('%s has changed (%s) after: %s', room{1}, last, ...
                                strjoin (older, ', '));
    end
  end
end

% A shallow clone holds few commits, which is no news.
function lines = unknownOnes (root, names)
  lines = {};
  if ~strcmp (gitLine (root, 'rev-parse --is-shallow-repository'), 'false')
    return
  end
  isUnknown = false (size (names));
  for i = 1:numel (names)
    for one = regexp (originOf (fileOf (root, names{i})).commit, '[0-9a-f]{7,}', 'match')
      kind = gitLine (root, ['cat-file -t ', one{1}]);
      isUnknown(i) = isUnknown(i) || ~strcmp (kind, 'commit');
    end
  end
  if any (isUnknown)
    lines = {['made by code that is in no commit of this clone: ', ...
              strjoin(names(isUnknown), ', ')]};
  end
end

function file = fileOf (root, csv)
  file = fullfile (root, 'benchmarks', 'results', [csv, '.csv']);
end

% A mark + behind a commit: code that was not committed; it counts as that commit.
function yes = isOlder (root, commits, folder)
  yes = false;
  for one = regexp (commits, '[0-9a-f]{7,}', 'match')
    changed = gitLine (root, sprintf ('log -1 --format=%%h %s %s..HEAD -- %s', ...
                                      codeOnly (), one{1}, folder));
    yes = yes || ~isempty (changed);
  end
end

% Commits with a changed line that is no remark.
function words = codeOnly ()
  words = '-G"^[[:space:]]*[^#%[:space:]]" --invert-grep --grep="^Results stay: "';
end

function text = gitLine (root, words)
  [~, text] = system (sprintf ('git -C %s %s 2> /dev/null', shellQuote (root), words));
  text = strtrim (text);
end

% SPDX-License-Identifier: GPL-3.0-only
