% SAYNOTES  Says the first notes on a result; all go to results/notes.txt.
%
% CALL: sayNotes (NOTES, FOLDER, SAY)
%
%   NOTES   1 x n cell of texts
%   FOLDER  of the case;  SAY  function handle that takes one line of text

function sayNotes (notes, folder, say)
  notes = unique (notes, 'stable');
  [~, ~] = mkdir (fullfile (folder, 'results'));
  writeAtomic (fullfile (folder, 'results', 'notes.txt'), ...
               [strjoin(notes(:)', "\n"), repmat("\n", 1, ~isempty (notes))]);
  if isempty (notes)
    return
  end
  most = 4;
  say ([countText(numel (notes), 'note'), ' (results/notes.txt):']);
  cellfun (@(note) say (['  WARNING: ', note]), notes(1:min (most, end)));
  if numel (notes) > most
    say (sprintf ('  and %d more', numel (notes) - most));
  end
  say ('');
end

%!test
%! folder = emptyFolder ();
%! text = evalc ('sayNotes ({''a'', ''b'', ''a''}, folder, @disp)');
%! assert (text, ["2 notes (results/notes.txt):\n  WARNING: a\n  WARNING: b\n\n"]);
%! assert (fileread (fullfile (folder, 'results', 'notes.txt')), "a\nb\n");
%! assert (evalc ('sayNotes ({}, folder, @disp)'), '');

% SPDX-License-Identifier: GPL-3.0-only
