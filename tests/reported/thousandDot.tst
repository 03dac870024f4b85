% Issue 47, report 10: 1.002 kg in a table with decimal commas was read as 1.002
% and nobody said that it may be 1002.

%!test
%! folder = reportedCase ('units');
%! file = fullfile (folder, 'measured.csv');
%! writeAtomic (file, strrep (fileread (file), ';2100;20;g;50 abs', ...
%!                            ';1.002;;kg;'));
%! [status, out] = startCommand (folder, 'check');
%! assert (status != 0);
%! assert (! isempty (strfind (out, 'got 1.002 in line 3')), out);
%! assert (! isempty (strfind (out, 'Write 1002 or 1,002.')), out);

% SPDX-License-Identifier: GPL-3.0-only
