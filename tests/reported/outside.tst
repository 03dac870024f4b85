% Another solver outside the model folder: it changed, and the old runs counted.

%!function [Case, records, nNew] = start (folder, P)
%!  raw = goodInput (folder);
%!  raw.root = fileparts (which ('DEcalioc'));
%!  raw.Input = struct ('model', {{'M'}}, 'cpu', 1, 'maxCPU', 1, ...
%!                      'numOfSam', 8);
%!  raw.optim = struct ('targetVal', {{[4, 1.9, 1.5]}}, 'tolRes', ...
%!                      {{[0.02, 0.02, 0.02]}});
%!  raw.modelVars = struct ();
%!  raw.assign = {'a', 'b'};
%!  raw.paramLims = [0, 0; 1, 2];
%!  Case = newCase (raw);
%!  [records, ~, nNew] = runJobs (newJobs (Case, P, [], 1, 'plan'), Case, ...
%!                                @(state) []);
%!endfunction
%!shared folder, solver, text
%! folder = fullfile (reportedCase ('outside'), 'case');
%! solver = fullfile (fileparts (folder), 'solver.sh');
%! text = fileread (fullfile (fileparts (folder), 'solver_v1.sh'));
%!test
%! writeAtomic (solver, text);
%! [~, first, nNew] = start (folder, [0.2, 0.4]);
%! assert ({first.status, nNew}, {'ok', 1});
%! [~, ~, nNew] = start (folder, [0.2, 0.4]);
%! assert (nNew, 0);
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0 && ~isempty (strfind (out, solver)), out);
%! % a new version: the old run counts no longer, and it is said why
%! writeAtomic (solver, strrep (text, '3+a', '4+a'));
%! [Case, second, nNew] = start (folder, [0.2, 0.4]);
%! assert (nNew, 1);
%! assert (second.results(1) - first.results(1), 1, 0.02);
%! [~, out] = startCommand (folder, 'status');
%! assert (~isempty (strfind (out, '1 of an earlier model')), out);
%! % the first one back: its run counts again
%! writeAtomic (solver, text);
%! [~, third, nNew] = start (folder, [0.2, 0.4]);
%! assert ({third.folder, nNew}, {first.folder, 0});

%!test
%! % a model that names nothing outside has the key of before; one that names a
%! % folder hears that a change there is not noticed
%! model = fullfile (folder, 'DEMmodels', 'M');
%! place = fileparts (folder);
%! copyfile (solver, fullfile (model, 'solver.sh'));
%! writeAtomic (fullfile (model, 'runscript'), "bash solver.sh\n");
%! h = hashModels (start (folder, [0.2, 0.4]));
%! [~, key] = system (['cd ', model, ' && find . -type f ! -path ', ...
%!                     '"./OctaveFuns/*" -print0 | LC_ALL=C sort -z | ', ...
%!                     'xargs -0 sha256sum']);
%! assert (h.input, hash ('sha256', [hash('sha256', key), '|1|']));
%! mkdir (fullfile (place, 'lib'));
%! writeAtomic (fullfile (model, 'runscript'), ...
%!              ["cp -r ../../../../lib mine\nbash solver.sh\n"]);
%! [status, out] = startCommand (folder, 'check');
%! at = strfind (out, fullfile (place, 'lib'));
%! assert (status == 0 && ~isempty (at), out);
%! assert (strfind (out(at:end), 'NOT noticed') > 0);

% SPDX-License-Identifier: GPL-3.0-only
