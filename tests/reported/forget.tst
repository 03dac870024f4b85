% A run that the user took out of use came back: the next start made it again
% with the same seed, and the same rubbish counted. And what cancel ended
% counted as done. And the result that grew from forgotten runs was still "Calibrated".

%!function raw = rawOf (folder)
%!  raw = goodInput (folder);
%!  raw.root = fileparts (which ('DEcalioc'));
%!  raw.Input = struct ('model', {{'M'}}, 'cpu', 1, 'maxCPU', 1, ...
%!                      'numOfSam', 8);
%!  raw.optim = struct ('targetVal', {{[4, 1.9, 1.5]}}, 'tolRes', ...
%!                      {{[0.02, 0.02, 0.02]}});
%!  raw.modelVars = struct ();
%!  raw.assign = {'a', 'b'};
%!  raw.paramLims = [0, 0; 1, 2];
%!endfunction
%!shared folder, Case, jobs
%! folder = reportedCase ('stale');
%! Case = newCase (rawOf (folder));
%! jobs = newJobs (Case, [0.2, 0.4; 0.6, 1.2], [], 1, 'plan');
%!test
%! first = runJobs (jobs, Case, @(state) []);
%! [status, out] = startCommand (folder, 'forget . M 1');
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, 'another packing')));
%! [again, ~, nNew] = runJobs (jobs, Case, @(state) []);
%! assert (nNew, 1);
%! out = strcmp ({first.folder}, fullfile (folder, 'optim', 'M', '0001'));
%! assert (again(out).seed ~= first(out).seed);
%! assert (again(out).status, 'ok');
%! assert (~isequal (again(out).results, first(out).results));
%! % whose case made it stands in the store only
%! assert (isequal (rmfield (again(~out), 'owner'), rmfield (first(~out), 'owner')));
%! % a later start finds that one; so does the published call
%! [third, isReused] = runJobs (jobs, Case, @(state) []);
%! assert (all (isReused));
%! assert ({third.folder}, {again.folder});
%! assert (nthargout (2, @() runScript ([jobs(out).params, 1, 1], 'M', Case, ...
%!                                      jobs(out))).folder, again(out).folder);
%! s = caseStatus (Case, []);
%! assert ([s.models.done], 2);
%! % the second packing out of use as well: a third one
%! [~, number] = fileparts (again(out).folder);
%! startCommand (folder, ['forget . M ', number]);
%! fourth = runJobs (jobs(out), Case, @(state) []);
%! assert (numel (unique ([first(out).seed, again(out).seed, fourth.seed])), 3);
%! % and back: the first one counts again
%! startCommand (folder, 'forget . M 1 --back');
%! assert (runJobs (jobs(out), Case, @(state) []).folder, first(out).folder);

%!test
%! % ended from outside, by its guard or with a signal of its own: not done
%! marks = {"143 1.0 killed\n", "0 1.0 killed\n", "137 1.0 finished\n"};
%! before = sum (caseStatus (Case, []).plan(1));
%! for k = 1:numel (marks)
%!   job = newJobs (Case, [0.1, 0.1 * k], [], 1, 'plan');
%!   place = prepareRun (job, Case);
%!   writeAtomic (fullfile (place, 'end.mark'), marks{k});
%!   runs = runsOfCase (Case);
%!   assert (runs(strcmp ({runs.folder}, place)).state, 'lost');
%! end
%! s = caseStatus (Case, []);
%! assert ([s.models.done, s.models.lost], [3, 3]);
%! assert (s.plan(1), before);

% SPDX-License-Identifier: GPL-3.0-only
