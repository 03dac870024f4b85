% READTAKEN  Which runs of a shared store a case has taken as samples.
%
% CALL: [LIST, MARK, CASES] = readTaken (FOLDER)
%
%   FOLDER  case folder (text): its results/library.csv is read
%   LIST    n x 2, number of the model and of the run; n may be 0: the store had
%           none when the case was started first
%   MARK    first line of the file (text), of the input that it holds for; ''
%           where there is no such file, or no whole one
%   CASES   n x 1 cell, which case made each run
%
% See also: libraryRuns, libraryLine

function [list, mark, cases] = readTaken (folder)
  [list, mark, cases] = deal (zeros (0, 2), '', cell (0, 1));
  text = checkReadText (fullfile (folder, 'results', 'library.csv'));
  lines = strsplit (text, "\n");
  isWhole = numel (lines) > 2 && isempty (lines{end}) && ...
            strcmp (lines{2}, 'number,run,model,case');
  parts = regexp (lines(3:end - 1), '^(\d+),(\d+),[^,]*,(.*)$', 'tokens', ...
                  'once');
  if isWhole && ~any (cellfun (@isempty, parts))
    mark = lines{1};
    parts = horzcat (cell (3, 0), parts{:})';  % columns, of a cell of lines
    list = reshape (str2double (parts(:, 1:2)), [], 2);
    cases = parts(:, 3);
  end
end

%!function [list, mark, cases] = of (text)
%!  folder = emptyFolder ();
%!  mkdir (fullfile (folder, 'results'));
%!  writeAtomic (fullfile (folder, 'results', 'library.csv'), text);
%!  [list, mark, cases] = readTaken (folder);
%!endfunction
%!test
%! % none, one, several; no file, a broken one
%! head = "# abc\nnumber,run,model,case\n";
%! [list, mark, cases] = of (head);
%! assert ({list, mark, cases}, {zeros(0, 2), '# abc', cell(0, 1)});
%! [list, mark, cases] = of ([head, "1,7,M,/a, b\n"]);
%! assert ({list, mark, cases}, {[1, 7], '# abc', {'/a, b'}});
%! assert (of ([head, "1,7,M,/a\n2,12,N,\n"]), [1, 7; 2, 12]);
%! for text = {'', '# abc', "# abc\n", [head, '1,7,M,/a'], [head, "1,7\n"], ...
%!             ["\n\n\n", head], "x\ny\n1,7,M,/a\n"}
%!   [list, mark] = of (text{1});
%!   assert ({list, mark}, {zeros(0, 2), ''});
%! end
%! assert (readTaken ('/nowhere'), zeros (0, 2));

% SPDX-License-Identifier: GPL-3.0-only
