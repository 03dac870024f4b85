% A file of a trial by hand in the model folder: a solver that crashed left it,
% its values were those of the target, and the set was called calibrated.

%!shared folder, model
%! folder = reportedCase ('leftover');
%! model = fullfile (folder, 'DEMmodels', 'M');
%!test
%! for name = {'check', 'run'}
%!   [status, out] = startCommand (folder, name{1});
%!   assert (status == 1, out);
%!   assert (~isempty (strfind (out, 'DEMmodels/M/out: expected')), out);
%!   assert (~isempty (strfind (out, 'result 1 is 4.29')), out);
%! end
%! assert (~isfolder (fullfile (folder, 'optim')));

%!test
%! % siblings: a link to it, in a subfolder, in the place of one result alone,
%! % read of the model folder
%! funs = fullfile (model, 'OctaveFuns', 'getResults.m');
%! code = fileread (funs);
%! movefile (fullfile (model, 'out'), fullfile (folder, 'elsewhere'));
%! symlink (fullfile (folder, 'elsewhere'), fullfile (model, 'out'));
%! left = @() checkFindModels (struct ('model', 'M', 'cpu', 1), folder, ...
%!                             folder, 'full').left(:, 3);
%! assert (left (), {'out'; 'out'});
%! unlink (fullfile (model, 'out'));
%! assert (left (), cell (0, 1));
%! mkdir (fullfile (model, 'post'));
%! copyfile (fullfile (folder, 'elsewhere'), fullfile (model, 'post', 'out'));
%! writeAtomic (funs, strrep (code, '''/out''', '''/post/out'''));
%! assert (left (), {'post/out'; 'post/out'});
%! writeAtomic (fullfile (model, 'post', 'out'), '4.29');
%! assert (left (), {'post/out'});
%! ofModel = strrep (code, '''optim/'', model, ''/'', folderName, ''/out''', ...
%!                   '''DEMmodels/M/post/out''');
%! assert (~isequal (ofModel, code));
%! writeAtomic (funs, ofModel);
%! assert (left (), {'post/out'});
%! rmdir (fullfile (model, 'post'), 's');
%! writeAtomic (funs, code);

%!test
%! % a log of a trial says RUN COMPLETE, the solver does not start
%! writeAtomic (fullfile (model, 'log.liggghts'), "Setting up\nRUN COMPLETE\n");
%! writeAtomic (fullfile (model, 'in.M'), "print \"RUN COMPLETE\"\n");
%! writeAtomic (fullfile (model, 'runscript'), ...
%!              "echo \"solver: no licence\" >&2; exit 0\n");
%! raw = goodInput (folder);
%! raw.root = fileparts (which ('DEcalioc'));
%! raw.Input = struct ('model', {{'M'}}, 'cpu', 1, 'maxCPU', 1, ...
%!                     'numOfSam', 8);
%! raw.optim = struct ('targetVal', {{[4.3, 1.7]}}, 'tolRes', {{[0.02, 0.02]}});
%! raw.modelVars = struct ();
%! raw.assign = {'a', 'b'};
%! raw.paramLims = [0, 0; 1, 1];
%! Case = newCase (raw);
%! job = newJobs (Case, [0.5, 0.5], [], 1, 'plan');
%! record = executeLocal (job, Case, @(state) []);
%! assert (record.status, 'failed');
%! assert (~isempty (strfind (record.message, 'last line')), record.message);
%! assert (~isfile (fullfile (record.folder, 'log.liggghts')));
%! % of a run that has written it, it counts
%! writeAtomic (fullfile (model, 'runscript'), ...
%!              ["echo RUN COMPLETE > log.liggghts\n", ...
%!               "printf '4\\n2\\n' > out\n"]);
%! Case = newCase (raw);
%! record = executeLocal (newJobs (Case, [0.5, 0.5], [], 1, 'plan'), Case, ...
%!                        @(state) []);
%! assert ({record.status, record.results}, {'ok', [4, 2]});

% SPDX-License-Identifier: GPL-3.0-only
