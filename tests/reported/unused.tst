% A variable that no file of the model uses was fitted, and nothing was said.

%!test
%! folder = reportedCase ('stale');
%! file = fullfile (folder, 'DEMmodels', 'M', 'data.head');
%! writeAtomic (file, [fileread(file), "variable c equal 1 # the wall\n"]);
%! file = fullfile (folder, 'loadInput.m');
%! text = strrep (fileread (file), '''b''}', '''b'', ''c''}');
%! writeAtomic (file, strrep (text, '[0.0 0.0; 1.0 2.0]', ...
%!                            '[0 0 0; 1 2 3]'));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, ['no file of the models uses the ' ...
%!                                  'variable c: it changes nothing'])), out);
%! assert (isempty (regexp (out, 'variable [ab]:', 'once')), out);
%! % used by a formula of data.head, it is used
%! file = fullfile (folder, 'DEMmodels', 'M', 'data.head');
%! writeAtomic (file, [fileread(file), "variable d equal 2*${c}\n"]);
%! [~, out] = startCommand (folder, 'check');
%! assert (isempty (strfind (out, 'it changes nothing')), out);

% SPDX-License-Identifier: GPL-3.0-only
