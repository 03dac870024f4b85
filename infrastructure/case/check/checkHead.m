% CHECKHEAD  Lists the variables that the data.head of a model declares.
%
% CALL: HEAD = checkHead (FOLDER)
%       HEAD = checkHead (FOLDER, NAME)
%       HEAD = checkHead (FOLDER, NAME, DEPTH)
%
%   FOLDER  model folder (text)
%   NAME    file in it ('data.head');  DEPTH  of the file that includes it (0)
%   HEAD    1 x n struct array, in the order of the file: name, style ('equal',
%           'string', ...), value, remark behind # (texts). Files that data.head
%           includes are read too, and before them the data.head of the models
%           that it starts from (stagesOf).

function head = checkHead (folder, name, depth)
  if nargin < 2
    name = 'data.head';
  end
  if nargin < 3
    depth = 0;
  end
  head = struct ('name', cell (1, 0), 'style', '', 'value', '', 'remark', '');
  if strcmp (name, 'data.head') && depth < 3
    % the models that it starts from take the same variables
    [~, stages] = stagesOf (folder);
    for stage = stages
      head = [head, checkHead(stage{1}, name, depth + 1)];
    end
  end
  text = checkReadText (fullfile (folder, name));
  found = regexp (text, ...
                  ['^[ \t]*(variable|include)[ \t]+(\S+)' ...
                   '(?:[ \t]+(\w+)[ \t]+([^#\r\n]*)' ...
                   '(?:#[ \t]*([^\r\n]*))?)?'], ...
                  'tokens', 'lineanchors');
  for k = 1:numel (found)
    words = [found{k}, {'', '', ''}];
    if strcmp (words{1}, 'variable')
      head(end + 1) = struct ('name', words{2}, 'style', words{3}, ...
                              'value', strtrim (words{4}), ...
                              'remark', strtrim (words{5}));
    elseif depth < 3
      inside = checkHead (folder, words{2}, depth + 1);
      head(end + 1:end + numel (inside)) = inside;
    end
  end
end

%!test
%! [folder, put] = emptyFolder ();
%! put ('data.head', ["variable a equal 5e6 # Pa\r\n", ...
%!                    "# variable no equal 1\n\tvariable  b string x\n", ...
%!                    "include more.inc\nvariable c\n"]);
%! put ('more.inc', 'variable d equal 2*${a}');
%! head = checkHead (folder);
%! assert ({head.name}, {'a', 'b', 'd', 'c'});
%! assert ({head.style}, {'equal', 'string', 'equal', ''});
%! assert ({head.value}, {'5e6', 'x', '2*${a}', ''});
%! assert ({head.remark}, {'Pa', '', '', ''});
%!assert (size (checkHead ('/nowhere')), [1, 0])

% SPDX-License-Identifier: GPL-3.0-only
