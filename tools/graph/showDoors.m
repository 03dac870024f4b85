% SHOWDOORS  Writes the map of the rooms, or says that it is old.
%
% CALL: failed = showDoors (root, isCheck)
%
% root     folder of the toolbox (text)
% isCheck  true: write nothing (logical, default false)
% failed   1 where infrastructure/README.md is not the map of the functions as
%          they are, or the rooms have more doors than MOSTDOORS; else 0
%
% A room is a folder of infrastructure/ with all its subfolders, a door one of
% its functions that another room, a main script or a command calls. Printed are
% the doors of each room and what hangs on the seven doors that are walked
% through most: the files that they call in the end, and the lines of code there
% (no comment, no test, no empty line).
%
% See also: folderCalls, showGraph

function failed = showDoors (root, isCheck)
  if nargin < 2
    isCheck = false;
  end
  mostDoors = 157;
  [names, places, calls, inside, files] = folderCalls (root);
  rooms = roomsOf (places);
  isDoor = doorsOf (rooms, calls) & ~strcmp (rooms, 'main');
  [map, unknown] = mapText (root, names, places, files, isDoor);
  file = fullfile (root, 'infrastructure', 'README.md');
  faults = strcat ({'Without a line in the map: '}, unknown);
  if ~isCheck
    writeAtomic (file, map);
  elseif exist (file, 'file') ~= 2 || ~strcmp (fileread (file), map)
    faults{end + 1} = 'infrastructure/README.md is old. Make it again: make map';
  end
  printDoors (rooms, isDoor, inside);
  printWeights (names, calls, files);
  if nnz (isDoor) > mostDoors
    faults{end + 1} = sprintf ('%d doors, at most %d', nnz (isDoor), mostDoors);
  end
  printf ('%s\n', faults{:});
  failed = double (~isempty (faults));
end

% N x 1 logical: is it called from another room?
function isDoor = doorsOf (rooms, calls)
  [~, ~, roomOf] = unique (rooms);
  isDoor = any (calls & roomOf ~= roomOf', 1)';
end

% What is done in each room, in the order in which the map tells of them.
function list = purposes ()
  list = {'published', ['the steps of the published program, with its names and ' ...
                        'arguments: a case of 2017 runs unchanged']; ...
          'case', ['reads a case once: loadInput.m, models, measured values, settings; ' ...
                   'says what is wrong with it']; ...
          'problem', 'what is asked: targets with tolerance and noise, limits, levels'; ...
          'runs', ['makes, finds, reads, keeps, imports and exports DEM runs; locks ' ...
                   'the store; executors/: on this machine, in queues']; ...
          'surrogates', 'one Kriging model for each response: fit, predict, leave one out'; ...
          'calibration', 'from plan to the confirmed set; decides when it is calibrated'; ...
          'diagnosis', 'diagnoses what is left between model and measurement'; ...
          'effects', ['what the model may lack, and what can have happened in the plant: ' ...
                      'effects.csv and causes.csv, a row each']; ...
          'report', 'what is said: tables, sentences, page, JSON'; ...
          'measure', 'reads particle dumps for getResults; all of it is for users'' models'; ...
          'wings/command', 'the commands of bin/decalioc, which calls commandMain alone'; ...
          'wings/script', 'a model of a DEM script of the user''s own'; ...
          'kit', ['all public, knows nothing of DEM: files (atomic writing, tables, ' ...
                  'shell), fields of structs, text, statistics']};
end

% Where a reader begins who asks for what no door shows: files below infrastructure/.
function list = questions ()
  list = {'When is a set calibrated?', {'calibration/confirmSet.m', ...
                                        'calibration/private/confirmPublished.m'}; ...
          'Where does a run start?', {'runs/process/startRun.m', 'runs/process/guard.sh'}; ...
          'How sure is a measured reading?', {'case/measured/private/varianceComponents.m', ...
                                              'problem/private/withCondition.m'}; ...
          'Which cause is named?', {'diagnosis/verdict/weighCauses.m', ...
                                    'diagnosis/verdict/private/nameCause.m'}; ...
          'Who chooses the verdict''s words?', {'report/decideCase.m', ...
                                                'report/gap/decideGap.m', ...
                                                'report/words/words.txt'}; ...
          'Where does a new cause go?', {'effects/effects.csv', ...
                                         'effects/effectGain.m'}};
end

% MAP: text. UNKNOWN: 1 x n cellstr, rooms and doors about which it says nothing.
function [map, unknown] = mapText (root, names, places, files, isDoor)
  list = purposes ();
  tops = roomsOf (places);
  unknown = setdiff (tops, [list(:, 1); {'main'}])';
  head = ["# The map\n\nA room is a folder. Listed are its doors, the functions ", ...
          "that other rooms call, wherever they\nstand in it; what only its own ", ...
          "functions call can be left until it is needed. Who may call\nwhom: ", ...
          "`tools/graph/showGraph.m`. Made by `make map`.\n\n"];
  [first, gone] = answers (root);
  unknown = [unknown, gone];
  parts = {head, first};
  for k = 1:rows (list)
    mine = strcmp (tops, list{k, 1});
    parts{end + 1} = sprintf ("\n## %s\n\n%s (%d files).\n\n", list{k, 1}, ...
                              upperFirst (list{k, 2}), nnz (mine));
    [~, order] = sort (strcat (places, '/', names));
    for j = order(mine(order) & isDoor(order))'
      says = helpLine (files{j});
      if isempty (says)
        unknown{end + 1} = names{j};
      end
      path = strrep (files{j}, fullfile (root, 'infrastructure', filesep), '');
      parts{end + 1} = sprintf ("* [`%s`](%s): %s\n", names{j}, path, says);
    end
  end
  map = [parts{:}];
end

% TEXT: a line each question. GONE: 1 x n cellstr, files that are not there.
function [text, gone] = answers (root)
  [text, gone] = deal ('', cell (1, 0));
  for row = questions ()'
    isThere = cellfun (@(f) isfile (fullfile (root, 'infrastructure', f)), row{2});
    gone = [gone, row{2}(~isThere)];
    links = cellfun (@(f) sprintf ('[`%s`](%s)', nthargout (2, @fileparts, f), f), ...
                     row{2}(isThere), 'UniformOutput', false);
    if ~isempty (links)
      text = sprintf ('%s* %s %s\n', text, row{1}, strjoin (links, ', '));
    end
  end
  if isempty (text)                      % the rooms of a test
    gone = cell (1, 0);
  end
end

function text = upperFirst (text)
  text(1) = upper (text(1));
end

% First line of the help, without the name.
function says = helpLine (file)
  says = regexp (fileread (file), '^% [A-Z0-9_]+  ([^\n]*)', 'tokens', 'once');
  says = [says{:}];
end

function printDoors (rooms, isDoor, inside)
  printf ('%-16s %6s %8s %6s %6s\n', 'room', 'files', 'private', 'doors', ...
          'share');
  for room = setdiff (unique (rooms), 'main')'
    mine = strcmp (rooms, room{1});
    printf ('%-16s %6d %8d %6d %5.0f%%\n', room{1}, nnz (mine), ...
            nnz (mine & inside), nnz (mine & isDoor), ...
            100 * nnz (mine & isDoor) / nnz (mine));
  end
  mine = ~strcmp (rooms, 'main');
  printf ('%-16s %6d %8d %6d %5.0f%%\n', 'all', nnz (mine), ...
          nnz (inside), nnz (isDoor), 100 * nnz (isDoor) / nnz (mine));
end

function printWeights (names, calls, files)
  lines = cellfun (@codeLines, files);
  total = 0;
  for door = {'confirmSet', 'newProblem', 'newCase', 'fitSurrogates', ...
              'runJobs', 'diagnoseMatrices', 'writePage'}
    reached = strcmp (names, door{1});
    before = 0;
    while nnz (reached) > before
      before = nnz (reached);
      reached = reached | any (calls(reached, :), 1)';
    end
    printf ('hangs on %-18s %4d files %6d lines\n', door{1}, before, ...
            sum (lines(reached)));
    total = total + sum (lines(reached));
  end
  printf ('hangs on the seven: %d lines\n', total);
end

function n = codeLines (file)
  lines = strtrim (strsplit (fileread (file), "\n"));
  n = nnz (~cellfun (@isempty, lines) & ~strncmp (lines, '%', 1));
end

%!test
%! % two rooms: a door is what the other one calls; a map that is old is said
%! root = tempname ();
%! [~] = cellfun (@(f) mkdir (fullfile (root, 'infrastructure', f)), ...
%!                {'runs/private', 'kit'});
%! write = @(path, text) writeAtomic (fullfile (root, 'infrastructure', path), ...
%!                                    text);
%! write ('runs/make.m', "% MAKE  Makes.\nfunction make ()\n  own ();\n  save2 (1);\nend\n");
%! write ('runs/private/own.m', "% OWN  Its own.\nfunction own ()\nend\n");
%! write ('kit/save2.m', "% SAVE2  Saves.\nfunction save2 (x)\nend\n%!test\n");
%! said = evalc ('failed = showDoors (root);');
%! map = fileread (fullfile (root, 'infrastructure', 'README.md'));
%! old = evalc ('same = showDoors (root, true);');
%! write ('kit/save2.m', "% SAVE2  Keeps.\nfunction save2 (x)\nend\n");
%! old = evalc ('isOld = showDoors (root, true);');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (root, 's');
%! assert ([failed, same, isOld], [0, 0, 1]);
%! assert (~isempty (strfind (map, "* [`save2`](kit/save2.m): Saves.\n")));
%! assert (isempty (strfind (map, '`make`')) && isempty (strfind (map, 'own.m')));
%! assert (~isempty (regexp (said, 'kit +1 +0 +1 +100%')));
%! assert (~isempty (regexp (said, 'runs +2 +1 +0 +0%')));
%! assert (~isempty (strfind (old, 'make map')));

% SPDX-License-Identifier: GPL-3.0-only
