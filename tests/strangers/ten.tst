% Ten scripts of strangers' kinds: each becomes a model with one command and the edits
% that strangerModels lists, is checked, and runs. LIGGGHTS runs, one run a script.

%!test
%! folder = tempname ();
%! list = strangerModels (folder);
%! root = fileparts (fileparts (which ('startProgram')));
%! useLiggghts (root);
%! for m = list
%!   if ~isempty (m.prepare)
%!     assert (system (['cd ', shellQuote(m.folder), ' && ', m.prepare]), 0);
%!   end
%!   [status, out] = startCommand (m.folder, ['new --model M --script ', m.words, ...
%!                                            ' ../case']);
%!   assert (status == 0, [m.kind, ': ', out]);
%!   place = fullfile (fileparts (m.folder), 'case');
%!   for edit = m.edits'
%!     file = fullfile (place, 'DEMmodels', 'M', edit{1});
%!     text = fileread (file);
%!     assert (~isempty (strfind (text, edit{2})), text);
%!     writeAtomic (file, strrep (text, edit{2}, edit{3}));
%!   end
%!   [status, out] = startCommand (place, 'check --try');
%!   assert (status == 0 && isempty (strfind (out, 'WARNING')), [m.kind, ': ', out]);
%!   assert (~isempty (regexp (out, 'trial +M: ok', 'once')), [m.kind, ': ', out]);
%! end
%! % at most one place that a hand has to change, in one of the ten
%! assert (sum (cellfun (@rows, {list.edits})) <= 1);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
