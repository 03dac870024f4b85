% One plan of stand-in runs, some of which fail, through every executor that is
% there: the records must be the same, whoever made them.

%!function [records, text] = commonPlan (name, options)
%!  folder = fullfile (tempname (), 'it''s %a 1');
%!  mkdir (fileparts (folder));
%!  [Case, jobs] = slurmTestCase (folder, [1, 2, 9, 7, 8, 3.3], 0);
%!  Case.models.timeout = 3;
%!  Case.options.executor = name;
%!  Case.options.(name) = options;
%!  records = runJobs (jobs, Case, @(s) []);
%!  fields = {'model', 'stage', 'planRow', 'params', 'replicate', 'seed', ...
%!            'key', 'status', 'cause', 'results', 'funs'};
%!  text = cellfun (@(f) jsonencode ({records.(f)}), fields, ...
%!                  'UniformOutput', false);
%!  none = {Case.store, folder};
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (folder, 's');
%!endfunction

%!shared r, expected, quick
%! [r, expected] = commonPlan ('local', struct ());
%! quick = struct ('poll', 0.4, 'grace', 2, 'sets', 3, 'before', ...
%!                 {{'export WHERE="a queue"'}});

%!test
%! % what the plan must give
%! assert ({r.status}, {'ok', 'ok', 'failed', 'invalid', 'timeout', 'ok'});
%! assert ({r.cause}, {'', '', 'exit', 'output', 'time', ''});
%! assert (r(6).results, [3.3 + 2, 3.3 * 2], 1e-12);
%! assert (! isempty (strfind (r(3).message, 'too dense')));

%!test
%! % every executor has its turn here: a new one needs a block of its own
%! assert (sort (executorNames ()), ...
%!         {'gridengine', 'local', 'slurm', 'static'});

%!test
%! [~, text] = commonPlan ('static', struct ());
%! assert (text, expected);

%!testif ; slurmTestReady ()
%! config = getenv ('SLURM_CONF');
%! cluster = slurmTestUp (8);
%! tidy = onCleanup (@() slurmTestDown (cluster));
%! [~, text] = commonPlan ('slurm', quick);
%! setenv ('SLURM_CONF', config);
%! assert (text, expected);

%!testif ; gridengineTestReady ()
%! tidy = gridengineTestUp (8);
%! [~, text] = commonPlan ('gridengine', quick);
%! assert (text, expected);
