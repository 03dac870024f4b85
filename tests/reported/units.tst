% Issue 47, 17: measured in grams and radians, simulated in kg and degrees.

%!test
%! folder = reportedCase ('units');
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, 'converted to the unit of results.csv')));
%! lines = readMeasured (fullfile (folder, 'measured.csv'), {'Heap'});
%! model = struct ('name', 'Heap', ...
%!                 'folder', fullfile (folder, 'DEMmodels', 'Heap'));
%! lines = checkUnits (lines, model);
%! assert ([lines.value], [0.4625 * 180 / pi, 2.1], 1e-12);
%! assert ([lines.sd], [0.005 * 180 / pi, 0.02], 1e-12);
%! assert (lines(2).tol, 0.05, 1e-12);
%! assert ({lines.unit}, {'deg', 'kg'});
%!test
%! % seconds are no mass
%! folder = reportedCase ('units');
%! file = fullfile (folder, 'measured.csv');
%! writeAtomic (file, strrep (fileread (file), ';g;', ';s;'));
%! [status, out] = startCommand (folder, 'check');
%! assert (status != 0);
%! assert (! isempty (strfind (out, ['line 3, unit: expected a unit that ' ...
%!                                   'can be converted to ''kg''', ...
%!                                   ', as results.csv of Heap'])), out);

% SPDX-License-Identifier: GPL-3.0-only
