% Two cases on one store: what decalioc cancel and status of an idle one say of
% the other's runs, and that no process and no job of the other is ever hit.

%!function [A, B] = twoCases ()
%!  store = tempname ();
%!  mkdir (store);
%!  texts = {'', 'optim.targetVal = {[7.4, 12.6], 1.1}; '};
%!  for k = 1:2
%!    raw = standInCase (tempname ());
%!    writeLoadInput (raw.folder, sprintf ('Input.store = ''%s''; %s', ...
%!                                         store, texts{k}));
%!    writeAtomic (fullfile (raw.folder, 'DEMmodels', 'First', ...
%!                           'runscript'), "sleep 100\n");
%!    raw.Input.store = store;
%!    cases{k} = newCase (raw);
%!  end
%!  [A, B] = cases{:};
%!endfunction
%!function [text, said] = cancelled (Case)
%!  % with stand-ins for scancel and qdel that write down what they are asked
%!  bin = tempname ();
%!  mkdir (bin);
%!  for name = {'scancel', 'qdel'}
%!    file = fullfile (bin, name{1});
%!    writeAtomic (file, sprintf ("#!/bin/sh\necho \"%s $*\" >> %s/said\n", ...
%!                                name{1}, bin));
%!    system (['chmod +x ', file]);
%!  end
%!  before = getenv ('PATH');
%!  back = onCleanup (@() setenv ('PATH', before));
%!  setenv ('PATH', [bin, ':', before]);
%!  [~, text] = startCommand (Case.folder, 'cancel');
%!  said = readText (fullfile (bin, 'said'));
%!endfunction
%!function name = inQueue (Case, queue, name)
%!  job = newJobs (Case, [5, 5], [], 1, 'plan')(1);
%!  batch = fullfile (Case.store, 'optim', ['.', queue], name);
%!  mkdir (fileparts (batch));
%!  mkdir (batch);
%!  writeAtomic (fullfile (batch, 'tasks'), ...
%!               sprintf ("%s\t%s\n", job.key, prepareRun (job, Case)));
%!  writeAtomic (fullfile (batch, 'before'), '');
%!endfunction
%!test
%! [A, B] = twoCases ();
%! % a run of B under way, one of a toolbox that did not note whose it is
%! job = newJobs (B, [1, 2], [], 1, 'plan')(1);
%! folder = prepareRun (job, B);
%! startRun (folder, B.root);
%! waitUntil (@() ~isempty (runPids (folder)));
%! old = prepareRun (rmfield (newJobs (B, [2, 2], [], 1, 'plan')(1), ...
%!                            {'origin', 'input', 'variables'}), B);
%! inQueue (B, 'slurm', 'decalioc-bbbbbbbbbbb1');
%! inQueue (B, 'gridengine', 'decalioc-bbbbbbbbbbb2');
%! [~, text] = startCommand (A.folder, 'status');
%! assert (~isempty (regexp (text, 'First +0 done, 0 running, 0 waiting')), text);
%! [text, said] = cancelled (A);
%! assert (~isempty (strfind (text, '0 run(s) ended here, 0 job array')), text);
%! assert (said, '');
%! assert (nthargout (2, @runPids, folder));
%! assert (isempty (readEndMark (folder)));
%! % its own arrays alone, by the name of each queue
%! inQueue (A, 'slurm', 'decalioc-aaaaaaaaaaa1');
%! inQueue (A, 'gridengine', 'decalioc-aaaaaaaaaaa2');
%! [text, said] = cancelled (A);
%! assert (~isempty (strfind (text, '2 job array(s) on Slurm and Grid Eng')) ...
%!         || ~isempty (strfind (text, 'on Grid Engine and Slurm')), text);
%! assert (sum (said == "\n"), 2);
%! assert (isempty (strfind (said, 'bbbbbbbbbbb')), said);
%! % B ends its own
%! text = cancelled (B);
%! assert (~isempty (strfind (text, '; 1 run(s) ended here')), text);
%! assert (readEndMark (folder).reason, 'killed');

% SPDX-License-Identifier: GPL-3.0-only
