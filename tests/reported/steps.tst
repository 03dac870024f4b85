% A script in steps, which jump from one file to the next: only the first one was
% copied, and no run came to its end. And what a trial by hand had written, the
% file named by --output among it, was copied into the model.

%!test
%! folder = reportedCase ('steps');
%! put = @(name, text) writeAtomic (fullfile (folder, name), text);
%! put ('in.step3', ["run 1\nprint \"${mu}\" file output_results\n", ...
%!                   "print \"RUN COMPLETE\"\n"]);
%! put ('output_results', '0.4');
%! put ('log.liggghts', "RUN COMPLETE\n");
%! [status, out] = startCommand (folder, ['new --script in.step1 --model ', ...
%!                                        'Steps --vary mu=0.2:0.8 ', ...
%!                                        '--target h=0.4 case']);
%! assert (status == 0, out);
%! assert (isempty (strfind (out, 'RUN COMPLETE')), out);
%! model = fullfile (folder, 'case', 'DEMmodels', 'Steps');
%! files = {'in.step1', 'in.step2', 'in.step3', 'output_results', ...
%!          'log.liggghts'};
%! assert (isfile (fullfile (model, files)), logical ([1, 1, 1, 0, 0]));
%! % one that is put there afterwards is a fault
%! copyfile (fullfile (folder, 'output_results'), model);
%! [status, out] = startCommand (folder, 'check case');
%! assert (status == 1, out);
%! assert (~isempty (strfind (out, 'Steps/output_results: expected')), out);

% SPDX-License-Identifier: GPL-3.0-only
