% BATCHPREVIEW  What would be submitted to a queue for runs; submits nothing.
%
% CALL: TEXT = batchPreview (QUEUE, JOBS, CASE)
%
%   QUEUE       see newQueue
%   JOBS, CASE  see batchExecute; JOBS are the runs that are missing
%   TEXT        lines for the user (1 x n char): the command that submits each
%               job array, the script of a job, and what it calls
%
% Where the program that submits is not on the PATH, the text says so, and an
% array may have 1000 tasks. Files are read only.

function text = batchPreview (queue, jobs, Case)
  opt = queue.options (Case.options);
  [opt.arraySize, fault] = queue.start ();
  first = 1:min (numel (jobs), floor (opt.maxInFlight));
  text = sprintf (['dry run   nothing is submitted. %d of %s would go to ' ...
                   '%s at first\n'], numel (first), countText (numel (jobs), 'run'), ...
                  queue.title);
  if ~isempty (fault)
    text = [text, sprintf(['NOTE      %s: start on a machine of the cluster ' ...
                           'to submit\n'], strsplit (fault, "\n"){end})];
  end
  parts = batchParts (first, jobs, Case, opt);
  calls = cellfun (@(part) callOf (part, jobs, Case, queue, opt), parts, ...
                   'UniformOutput', false);
  task = batchCall ('', queue, opt, Case.root);
  text = [text, calls{:}, sprintf('\njob script: %s\n', task{1}), ...
          indented(readText (task{1}))];
  if ~isempty (opt.before)
    text = [text, sprintf("\nfirst, in the job (Input.%s.before)\n", ...
                          queue.name), ...
            indented(sprintf ("%s\n", opt.before{:}))];
  end
  for name = unique ({jobs.model})
    folder = Case.models(strcmp (name{1}, {Case.models.name})).folder;
    file = fullfile (folder, 'runscript');
    text = [text, sprintf("\nthen the run of %s: %s\n", name{1}, file), ...
            indented(readText (file))];
  end
end

% The number in the name of an array is found when it is submitted.
function text = callOf (part, jobs, Case, queue, opt)
  [~, k] = ismember ({jobs(part).model}, {Case.models.name});
  limits = [Case.models(k).timeout];
  batch = struct ('name', 'decalioc-NUMBER', 'n', numel (part), ...
                  'cpu', Case.models(k(1)).cpu, ...
                  'minutes', batchMinutes (opt.time, limits));
  batch.path = runPlace (Case, ['.', queue.name], batch.name);
  words = queue.call (batch, opt, batchCall (batch.path, queue, opt, Case.root));
  isPlain = cellfun (@(w) ~isempty (regexp (w, '^[\w/.,:=%@+-]+$', 'once')), ...
                     words);
  words(~isPlain) = cellfun (@shellQuote, words(~isPlain), ...
                             'UniformOutput', false);
  text = sprintf ("\njob array of %s (%s)\n  %s\n", countText (batch.n, 'run'), ...
                  strjoin (unique ({jobs(part).model}), ', '), ...
                  strjoin (words, ' \\\n    '));
end

function text = indented (text)
  text = ['  ', strrep(regexprep (text, '\n+$', ''), "\n", "\n  "), "\n"];
end

%!test
%! % without sbatch: no program of a queue is called, no folder is made
%! before = getenv ('PATH');
%! back = onCleanup (@() setenv ('PATH', before));
%! empty = emptyFolder ();
%! for program = {'bash', 'sh', 'timeout'}
%!   system (sprintf ('ln -s "$(command -v %s)" %s/', program{1}, empty));
%! end
%! [~, jobs] = slurmTestCase (tempname (), 1:3, 0);
%! Case = slurmTestCase (tempname (), 1:3, 0);
%! Case.options.slurm = struct ('partition', 'long', 'time', 30, ...
%!                              'before', {{'module load openmpi'}});
%! setenv ('PATH', empty);
%! text = batchPreview (slurmExecutor (), jobs, Case);
%! for part = {'3 of 3 runs would go to Slurm', 'no sbatch and squeue on', ...
%!             '--partition=long', '--array=1-3', '--time=30', ...
%!             '#!/bin/bash', 'mkdir batch.claim', "\n  module load openmpi\n", ...
%!             fullfile(Case.models.folder, 'runscript')}
%!   assert (~isempty (strfind (text, part{1})), [part{1}, "\n", text]);
%! end
%! assert (~isfolder (fullfile (Case.store, 'optim')));

% SPDX-License-Identifier: GPL-3.0-only
