% FOLDERCALLS  Which functions of the toolbox call which.
%
% CALL: [names, places, calls, inside, files] = folderCalls (root)
%       [...] = folderCalls (root, further)
%
% root    folder of the toolbox (text)
% further 1 x n cellstr, folders of ROOT that are looked at, too ('tests')
% names   n x 1 cellstr, the product's functions and scripts: the .m files of
%         ROOT itself and of infrastructure/
% places  n x 1 cellstr, where each belongs: 'main' (main scripts, forms, what
%         stands in FURTHER),
%         'published' (infrastructure/ itself), or its folder there, with its
%         subfolder ('diagnosis/hypotheses'); a private folder is part of the
%         one that holds it
% calls   n x n logical, row calls column
% inside  n x 1 logical, in a private folder
% files   n x 1 cellstr, their paths
%
% A call is the name of another file as a word of the code, a handle of it, or
% the word that the text begins with which feval, str2func, cellfun, arrayfun,
% parcellfun or evalc is given. A text that they put a name together from,
% [PREFIX, ...], calls all functions that begin so. Comments, other texts,
% tests, fields and local variables do not count.
%
% See also: showGraph

function [names, places, calls, inside, files] = folderCalls (root, further)
  if nargin < 2
    further = {};
  end
  rooms = fullfile (root, 'infrastructure');
  below = cellfun (@(f) strsplit (genpath (fullfile (root, f)), pathsep ()), ...
                   [{'infrastructure'}, further], 'UniformOutput', false);
  folders = [{root}, below{:}];
  files = cell (0, 1);
  for k = find (~cellfun (@isempty, folders))
    files = [files; glob(fullfile (folders{k}, {'*.m', 'private/*.m'}))];
  end
  [homes, names] = cellfun (@fileparts, files, 'UniformOutput', false);
  [~, last] = cellfun (@fileparts, homes, 'UniformOutput', false);
  inside = strcmp (last, 'private');
  places = cellfun (@(f) placeOf (f, rooms), files, 'UniformOutput', false);
  calls = false (numel (files));
  for k = 1:numel (files)
    text = fileread (files{k});
    calls(k, :) = ismember (names, wordsOf (text)) | isNamed (names, text);
    calls(k, k) = false;
  end
end

function place = placeOf (file, rooms)
  place = 'main';
  if strncmp (file, [rooms, filesep], numel (rooms) + 1)
    rest = strsplit (file(numel (rooms) + 2:end), filesep ());
    rest(strcmp (rest, 'private')) = [];
    place = 'published';
    if numel (rest) > 1
      place = strjoin (rest(1:end - 1), '/');
    end
  end
end

% Words of a file that are neither variables nor local functions.
function words = wordsOf (text)
  words = {};
  code = codeOf (text);
  local = regexp (code, '^\s*function\s(?:[^=\n]*=)?\s*(\w+)', 'tokens', ...
                  'lineanchors');
  parts = regexp (code, '^\s*function\s', 'split', 'lineanchors');
  for k = 1:numel (parts)
    locals = [localsOf(parts{k}, k > 1), local{:}];
    used = regexp (parts{k}, '(?<![\w.])[A-Za-z]\w*', 'match');
    words = [words, setdiff(used, locals)];
  end
end

% Is a function called by a text that holds its name, or how its name begins?
function yes = isNamed (names, text)
  yes = false (size (names));
  text = regexprep (text, '\.\.\.\s*\n', ' ');
  lines = regexp (text, '^(?!\s*[%#]).*$', 'match', 'lineanchors', ...
                  'dotexceptnewline');
  found = regexp (lines, ['\<(?:feval|str2func|cellfun|arrayfun|' ...
                          'parcellfun|evalc)\s*\(\s*(?:\w+,\s*)?' ...
                          '(\[?)\s*[''"](\w+)(?=[''"]| \()'], 'tokens');
  for token = [found{:}]
    if isempty (token{1}{1})
      yes = yes | strcmp (names, token{1}{2});
    else
      yes = yes | strncmp (names, token{1}{2}, numel (token{1}{2}));
    end
  end
end

% A quote after a name, a bracket or a dot transposes; elsewhere it begins a
% text.
function code = codeOf (text)
  code = regexprep (text, ['(?<![\w)\]}''.])''(?:[^''\n]|'''')*''|', ...
                           '"(?:[^"\\\n]|\\.)*"|[%#][^\n]*'], ' ');
  code = regexprep (code, '\.\.\.\s*\n', ' ');
end

function variables = localsOf (code, isFunction)
  variables = {};
  if isFunction
    [head, code] = strtok (code, "\n");
    variables = regexp (head, '[A-Za-z]\w*', 'match');
  end
  one = regexp (code, ['(?:^|[;,]|\sfor)\s*\(?([A-Za-z]\w*)\s*', ...
                       '(?:[({.][^=\n]*)?(?<![=~<>!])=(?!=)'], ...
                'tokens', 'lineanchors');
  some = regexp (code, '\[([^\]=]*)\]\s*=(?!=)|@\s*\(([^)]*)\)', 'tokens');
  some = regexp (strjoin ([{' '}, some{:}], ' '), '(?<![\w.])[A-Za-z]\w*', ...
                 'match');
  variables = [variables, [one{:}], some];
end

%!test
%! root = tempname ();
%! inside = fullfile (root, 'infrastructure');
%! write = @(path, text) writeAtomic (fullfile (root, path), text);
%! [~] = cellfun (@(f) mkdir (fullfile (inside, f)), ...
%!                {'upper', 'lower/deep/private'});
%! write ('start.m', "1;\nshared = top (@base);\n");
%! write ('infrastructure/top.m', ["function y = top (f)\n", ...
%!   "  y = f (side)';\n  x.alone = 'alone'; % alone\n", ...
%!   "  [deepest, z] = size (y);\n  deepest (1);\nend\n%! alone ()\n"]);
%! write ('infrastructure/upper/side.m', ...
%!        "function y = side ()\n  y = [1, 2]' + deepest (...\n 3);\nend\n");
%! write ('infrastructure/lower/base.m', ["function y = base (side)\n", ...
%!   "  y = side;\nend\nfunction z = other ()\n", ...
%!   "  z = side () + alone ();\nend\nfunction y = alone ()\n  y = 1;\nend\n"]);
%! write ('infrastructure/lower/deep/deepest.m', ...
%!        "function y = deepest (x)\n  y = @(top) top;\nend\n");
%! write ('infrastructure/lower/deep/private/hidden.m', ...
%!        "function y = hidden ()\n  y = deepest (1);\nend\n");
%! write ('infrastructure/lower/alone.m', "function alone ()\nend\n");
%! write ('infrastructure/lower/named.m', ["function y = named ()\n", ...
%!   "  y = feval ('side', str2func ( ...\n ['dee', 'pest']));\n", ...
%!   "  % feval ('alone')\n  z = ['alone', 'top'];\n", ...
%!   "  parcellfun (2, 'base');\n  evalc ('top (2)');\n", ...
%!   "end\n%! feval ('top');\n"]);
%! [names, places, calls, isPrivate] = folderCalls (root);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (root, 's');
%! assert (sort (names), {'alone'; 'base'; 'deepest'; 'hidden'; 'named'; ...
%!                        'side'; 'start'; 'top'});
%! assert (names(isPrivate), {'hidden'});
%! at = @(name) find (strcmp (names, name));
%! assert (places([at('deepest'), at('hidden')]), {'lower/deep'; 'lower/deep'});
%! assert (places([at('start'), at('top')]), {'main'; 'published'});
%! [from, to] = find (calls);
%! made = sort (strcat (names(from), {' '}, names(to)));
%! assert (made, {'base side'; 'hidden deepest'; 'named base'; ...
%!                'named deepest'; 'named side'; 'named top'; ...
%!                'side deepest'; 'start base'; 'start top'; 'top side'});

% SPDX-License-Identifier: GPL-3.0-only
