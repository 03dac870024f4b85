% READINGNOTES  What is known of the scatter of readings, in sentences.
%
% CALL: NOTES = readingNotes (CASE)
%
%   CASE   see newCase
%   NOTES  1 x n struct array: label ('sessions', 'scatter'), text (a sentence
%          without a full stop); empty where nothing is known

function notes = readingNotes (Case)
  notes = struct ('label', {'sessions', 'scatter'}, ...
                  'text', {sessionNote(Case), scatterNote(Case)});
  notes = notes(~cellfun (@isempty, {notes.text}));
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! Case.sessions = struct ('df', 1, 'ratio', 2, 'given', false, 'names', {{'a', 'b'}});
%! notes = readingNotes (Case);
%! assert ({notes.label}, {'sessions'});
%! assert (strncmp (notes.text, 'sessions differ by 2.0 times', 28));

% SPDX-License-Identifier: GPL-3.0-only
