% A rig of one's own called Heap, of which a table of runs is there alone: the test
% rig of the toolbox was taken for it, and asked for its files and results.

%!test
%! folder = reportedCase ('rigCalledHeap');
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0 && ! isempty (strfind (out, '14 sets taken in')), out);
%! assert (! isempty (strfind (out, 'no folder; its runs are those of')), out);
%! [status, out] = startCommand (folder, 'import runs.csv .');
%! assert (status == 0, out);
%! % one that is to be run, and has no folder: one mistake that says why
%! file = fullfile (folder, 'loadInput.m');
%! text = fileread (file);
%! writeAtomic (file, strrep (text, 'Input.maxNewRuns = 0;', ''));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 1 && ! isempty (strfind (out, '1 problem in')), out);
%! assert (! isempty (strfind (out, 'Heap of the toolbox, a test rig')), out);
%! % the rig itself is found by its parameters, as before
%! writeAtomic (file, strrep (text, '''mu''', '''coefFrictionPP'''));
%! [status, out] = startCommand (folder, 'check');
%! assert (! isempty (strfind (out, 'DEMmodels/Heap/data.head declares')), out);

% SPDX-License-Identifier: GPL-3.0-only
