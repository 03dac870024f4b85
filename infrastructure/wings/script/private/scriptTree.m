% SCRIPTTREE  Where the files of a LIGGGHTS script lie in a model.
%
% CALL: TREE = scriptTree (FOUND, START, TAKEN)
%
%   FOUND  see scriptFiles;  START  folder in which LIGGGHTS is started (text)
%   TAKEN  1 x k cell of names that the model folder has of its own
%   TREE   scalar struct: from (1 x n cell of full paths), to (1 x n cell of
%          paths in the model), place (folder of the model in which LIGGGHTS is
%          started, '' for the model folder itself)
%
% Names such as ../STL/x.stl hold in the model, too: it starts at the folder that
% all files have in common, and LIGGGHTS is started below. So no script is
% changed. PLACE is 'script' where a file has a name of TAKEN.

function tree = scriptTree (found, start, taken)
  top = make_absolute_filename (start);
  start = top;
  script = found.scripts{1};
  tree.from = unique ([{script}, found.files]);
  % what is written to ../post must not leave the folder of the run
  beside = found.written(areBelow (found.written, fileparts (top)));
  while ~all (areBelow ([tree.from, beside], top))
    top = fileparts (top);
  end
  cut = numel (regexprep (top, '/$', '')) + 1;
  tree.place = start(cut + 1:end);
  tree.to = cellfun (@(path) path(cut + 1:end), tree.from, ...
                     'UniformOutput', false);
  first = strtok (tree.to, '/');
  if isempty (tree.place) && any (ismember (first, taken))
    tree.place = 'script';
    tree.to = strcat ('script/', tree.to);
    return
  end
  % the folders between become words of bash and Octave
  plain = regexprep (tree.place, '[^\w/ .+-]', '_');
  isIn = strncmp (tree.to, [tree.place, '/'], numel (tree.place) + 1);
  tree.to(isIn) = cellfun (@(path) [plain, path(numel (plain) + 1:end)], ...
                           tree.to(isIn), 'UniformOutput', false);
  tree.place = plain;
end

function yes = areBelow (paths, top)
  top = [regexprep(top, '/$', ''), '/'];
  yes = strncmp (paths, top, numel (top));
end

%!function tree = of (start, files, taken)
%!  found = struct ('scripts', {{[start, '/in.x']}}, 'files', {files}, ...
%!                  'written', {{'/elsewhere/x', '/a/post/d1'}});
%!  tree = scriptTree (found, start, taken);
%!endfunction
%!test
%! t = of ('/c/b', {'/c/b/m/x.stl'}, {'data.head'});
%! assert ({t.place, t.to}, {'', {'in.x', 'm/x.stl'}});
%! % with a folder beside it that is written to
%! t = of ('/a/b', {'/a/b/m/x.stl'}, {'data.head'});
%! assert ({t.place, t.to}, {'b', {'b/in.x', 'b/m/x.stl'}});
%! t = of ('/a/it''s/c', {'/a/STL/x.stl', '/a/it''s/c/y'}, {});
%! assert ({t.place, t.to}, {'it_s/c', {'STL/x.stl', 'it_s/c/in.x', ...
%!                                      'it_s/c/y'}});
%! t = of ('/d/b', {'/d/b/data.head'}, {'data.head'});
%! assert ({t.place, t.to}, {'script', {'script/data.head', 'script/in.x'}});
%! assert (of ('/a', {'/b/x'}, {}).to, {'a/in.x', 'b/x'});

% SPDX-License-Identifier: GPL-3.0-only
