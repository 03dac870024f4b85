% A history of an optimiser, parameters and one cost: from import to page, without
% anything that a cost does not tell.

%!test
%! folder = fullfile (tempname (), 'pile');
%! mkdir (folder);
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! lines = {'function [Input, optim, modelVars, assign, paramLims] = loadInput ()', ...
%!          'Input.model = {''Pile''};', 'Input.cpu = 1;', 'Input.maxCPU = 1;', ...
%!          'Input.numOfSam = 5;', 'Input.maxNewRuns = 0;', ...
%!          'optim.targetName = {{''error''}};', 'optim.role = {{''smallest''}};', ...
%!          'modelVars = struct ();', 'assign = {''friction'', ''rolling''};', ...
%!          'paramLims = [0.1, 0; 0.9, 0.3];', 'end'};
%! put ('loadInput.m', strjoin (lines, "\n"));
%! says = @(text, part) ~isempty (strfind (text, part));
%! % without the history it is said what is missing
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 1 && says (out, 'runs.csv with the history'), out);
%! table = ["friction,rolling,friction_std,overall_std,error\n", ...
%!          "0.3,0.1,0.1,0.2,0.8\n0.5,0.2,0.1,0.2,0.11\n0.7,0.1,0.1,0.2,inf\n", ...
%!          "0.5,0.2,0.1,0.2,0.13\n0.2,0.05,0.1,0.2,2.4\n"];
%! put ('history.csv', table);
%! put ('runs.csv', table);
%! for command = {'import history.csv', 'check'}
%!   [status, out] = startCommand (folder, command{1});
%!   assert (status == 0 && says (out, 'smallest'), out);
%! end
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 2, out);
%! assert (says (out, 'BEST SET KNOWN: smallest error 0.12, of 3 sets'), out);
%! assert (says (out, 'mean of 2 runs'), out);
%! assert (says (out, '1 row without a cost'), out);
%! best = jsondecode (fileread (fullfile (folder, 'results', 'best.json')));
%! assert ({best.params.friction, best.params.rolling}, {0.5, 0.2});
%! assert (~isfile (fullfile (folder, 'results', 'calibration.json')));
%! for command = {'status', 'report', 'export --for table'}
%!   [status, out] = startCommand (folder, command{1});
%!   assert (status == 0, out);
%! end
%! page = fileread (fullfile (folder, 'results', 'report.html'));
%! assert (says (page, 'Best set known') && says (page, '0.12'));
%! for word = {'90 %', 'chance', 'CALIBRATED'}
%!   assert (~says (page, word{1}), word{1});
%! end
%! [status, out] = startCommand (folder, 'diagnose');
%! assert (status == 1 && says (out, 'does not say which of them does'), out);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (folder), 's');

% SPDX-License-Identifier: GPL-3.0-only
