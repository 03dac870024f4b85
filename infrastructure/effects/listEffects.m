% LISTEFFECTS  Names all effects of the library.
%
% CALL: [NAMES, LIBRARY] = listEffects ()
%       [NAMES, LIBRARY] = listEffects (FOLDERS)
%
% FOLDERS  text or cell of folders that are looked in first, for instance that of
%          a case and its effects/; the toolbox's library comes last
% NAMES    1 x n cell, sorted: a row of effects.csv, or effectGain.m, which is
%          'gain'
% LIBRARY  1 x n struct, for getEffect: name, file (the table, or the function),
%          row (struct of the texts of its row, [] of a function); the first
%          folder that has a name counts, and there a function before the table
%
% Throws DEcalioc:listEffects:badTable.
%
% See also: getEffect, resolveEffects
function [names, library] = listEffects (folders)
  if nargin < 1
    folders = {};
  end
  folders = [cellstr(folders)(:).', {fileparts(mfilename ('fullpath'))}];
  library = struct ('name', {}, 'file', {}, 'row', {});
  for k = 1:numel (folders)
    library = [library, ofFunctions(folders{k}), ...
               ofTable(fullfile (folders{k}, 'effects.csv'))];
  end
  [names, first] = unique ({library.name}, 'first');
  library = library(first);
end

function list = ofFunctions (folder)
  list = struct ('name', {}, 'file', {}, 'row', {});
  for file = {dir(fullfile (folder, 'effect*.m')).name}
    word = regexp (file{1}, '^effect([A-Z]\w*)\.m$', 'tokens', 'once');
    if ~isempty (word)
      list(end + 1) = struct ('name', [lower(word{1}(1)), word{1}(2:end)], ...
                              'file', fullfile (folder, file{1}), 'row', []);
    end
  end
end

function list = ofTable (file)
  list = struct ('name', {}, 'file', {}, 'row', {});
  if ~isfile (file)
    return
  end
  rows = tableRows (file);
  needed = {'name', 'variables', 'neutral', 'weakest', 'strongest'};
  if ~all (isfield (rows, needed))
    error ('DEcalioc:listEffects:badTable', ...
           ['listEffects: %s must have the columns %s, got %s. Take ' ...
            'infrastructure/effects/effects.csv of the toolbox as a pattern.'], ...
           file, strjoin (needed, ', '), strjoin (fieldnames (rows)', ', '));
  end
  [~, first] = unique ({rows.name}, 'first');
  twice = setdiff (1:numel (rows), first);
  if ~isempty (twice)
    error ('DEcalioc:listEffects:badTable', ...
           'listEffects: %s must name each effect once, got %s twice. Take one out.', ...
           file, rows(twice(1)).name);
  end
  for k = 1:numel (rows)
    list(k) = struct ('name', rows(k).name, 'file', file, 'row', rows(k));
  end
end

%!test % sorted, no helper function among them; rows and functions
%! names = listEffects ();
%! assert (issorted (names));
%! assert (all (ismember ({'cohesion', 'gain'}, names)));
%! assert (~any (strcmp (names, 'sOfModel')));

%!test % a case's own file comes first, a row of its table, too
%! folder = emptyFolder ();
%! file = fullfile (folder, 'effectCohesion.m');
%! fclose (fopen (file, 'w'));
%! table = fullfile (folder, 'effects.csv');
%! writeAtomic (table, ["name,variables,neutral,weakest,strongest\n", ...
%!                      "bounce,e,1,0.5,2\ntilt,t,0,0,9\n"]);
%! [names, library] = listEffects (folder);
%! from = @(name) library(strcmp (names, name)).file;
%! assert ({from('cohesion'), from('bounce'), from('tilt')}, {file, table, table});
%! writeAtomic (table, "name,limits\nx,1\n");
%! fail ('listEffects (folder)', 'must have the columns name, variables');
%! writeAtomic (table, ["name,variables,neutral,weakest,strongest\n", ...
%!                      "x,e,1,0.5,2\nx,t,0,0,9\n"]);
%! fail ('listEffects (folder)', 'got x twice');
%! delete (file);
%! delete (table);
%! rmdir (folder);

% SPDX-License-Identifier: GPL-3.0-only
