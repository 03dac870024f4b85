% SCRIPTROLES  Which words of a LIGGGHTS command are files.
%
% CALL: [ISREAD, ISWRITTEN] = scriptRoles (WORDS)
%
%   WORDS      1 x n cell of the command, see scriptCommands
%   ISREAD     1 x n logical: the file must be there
%   ISWRITTEN  1 x n logical: the command makes it
%
% "file NAME" is read by meshes and templates of particles, and written by all
% other fixes.

function [isRead, isWritten] = scriptRoles (words)
  n = numel (words);
  [isRead, isWritten] = deal (false (1, n));
  reads = {'include', 2; 'jump', 2; 'read_data', 2; 'read_restart', 2; ...
           'read_dump', 2; 'rerun', 2};
  writes = {'write_restart', 2; 'write_data', 2; 'log', 2; 'dump', 6; ...
            'write_dump', 4; 'restart', 3; 'restart', 4};
  isRead(numbersOf (reads, words)) = true;
  isWritten(numbersOf (writes, words)) = true;
  behind = [false, strcmp(words(1:end - 1), 'file') | strcmp(words(1:end - 1), 'append')];
  style = '';
  if n > 3
    style = words{4};
  end
  switch words{1}
    case 'variable'
      isRead(4:end) = n > 3 && any (strcmp (words{3}, {'file', 'atomfile'}));
    case 'region'
      isRead = isRead | behind;
    case 'fix'
      if ~isempty (regexp (style, '^(mesh/|particletemplate/)', 'once'))
        isRead = isRead | behind;
      else
        isWritten = isWritten | behind;
      end
    case {'print', 'info'}
      isWritten = isWritten | behind;
    case 'shell'
      % the last word is what cp and mv make
      isWritten(end) = n > 2 && any (strcmp (words{2}, {'cp', 'mv', 'ln'}));
  end
end

function places = numbersOf (table, words)
  places = [table{strcmp(table(:, 1), words{1}), 2}];
  places = places(places <= numel (words));
end

%!function [r, w] = roles (line)
%!  words = strsplit (line, ' ');
%!  [r, w] = scriptRoles (words);
%!  [r, w] = deal (words(r), words(w));
%!endfunction
%!test
%! table = {'jump in.2 here', {'in.2'}, {}; 'log own', {}, {'own'}; ...
%!          'fix m all mesh/surface file a.stl type 1', {'a.stl'}, {}; ...
%!          'fix t all particletemplate/multisphere 1 spheres file c.dat', ...
%!          {'c.dat'}, {}; 'fix w all massflow/mesh file f append g', {}, ...
%!          {'f', 'g'}; 'restart 10 a b', {}, {'a', 'b'}; ...
%!          'dump d all custom 10 post/d*.txt id', {}, {'post/d*.txt'}; ...
%!          'region r mesh/tet file a.vtk', {'a.vtk'}, {}; ...
%!          'variable v file list.txt', {'list.txt'}, {}; ...
%!          'shell cp a b', {}, {'b'}; 'run 1', {}, {}};
%! for row = table'
%!   [r, w] = roles (row{1});
%!   assert (isequal (r, row{2}) || isempty (r) && isempty (row{2}), row{1});
%!   assert (isequal (w, row{3}) || isempty (w) && isempty (row{3}), row{1});
%! end

% SPDX-License-Identifier: GPL-3.0-only
