% All runs write to one file outside their folders and copy it then: runs at the same
% time had each other's results, and the calibration threw the right ones out.

%!function [status, out] = with (folder, varargin)
%!  file = fullfile (folder, 'DEMmodels', 'Slope', 'runscript');
%!  text = strrep (fileread (file), '${TMPDIR:-/tmp}/slopework', ...
%!                 fullfile (folder, 'work'));
%!  for k = 1:2:numel (varargin)
%!    text = strrep (text, varargin{k:k + 1});
%!  end
%!  writeAtomic (file, text);
%!  [status, out] = startCommand (folder, 'run');
%!endfunction

%!test
%! folder = reportedCase ('sharedScratchFile');
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, '/slopework, outside its folder')), out);
%! assert (isempty (strfind (out, 'NOT noticed')), out);
%! % two runs at a time that take 0.2 s: all of the plan would have to miss each other
%! [status, out] = with (folder);
%! assert (status == 1, out);
%! assert (! isempty (strfind (out, 'each run of Slope must have results of its own')));
%! assert (! isfile (fullfile (folder, 'results', 'calibration.json')));

%!test
%! % one at a time, where a program that fails leaves what the run before has written
%! folder = reportedCase ('sharedScratchFile');
%! file = fullfile (folder, 'loadInput.m');
%! writeAtomic (file, strrep (fileread (file), 'maxCPU = 2', 'maxCPU = 1'));
%! fails = 'awk ''$2 == "mu" {m = $4} END {exit (m > 0.6)}'' data.head && awk ''';
%! [status, out] = with (folder, 'awk ''', fails);
%! assert (status == 1, out);
%! assert (! isempty (strfind (out, 'the same ones to the last digit')), out);

%!test
%! % a folder of each run's own is what is right
%! folder = reportedCase ('sharedScratchFile');
%! [status, out] = with (folder, [fullfile(folder, 'work'), '; mkdir'], ...
%!                       [fullfile(folder, 'work'), '$$; mkdir']);
%! assert (any (status == [0, 2]), out);
%! [~, out] = startCommand (folder, 'check');
%! assert (isempty (strfind (out, 'outside its folder')), out);

% SPDX-License-Identifier: GPL-3.0-only
