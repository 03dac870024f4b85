% GRIDENGINELOOK  Asks Grid Engine once about all arrays of a plan.
%
% CALL: [OK, TEXT, TASKS] = gridengineLook (NAMES, SIZES)
%
%   arguments as in slurmLook
%
% qstat lists what waits or runs, one element a task. What has ended is not
% there any more: the run's end mark says how, and without one the run was
% killed or cancelled.

function [ok, text, tasks] = gridengineLook (names, sizes)
  [status, text] = system (['timeout 60 qstat -xml -g d -u "$(id -un)" ' ...
                            '2>&1']);
  ok = status == 0;
  parts = regexp (text, ['<JB_name>([^<]*)</JB_name>.*?<state>([^<]*)', ...
                         '</state>.*?<tasks>([^<]*)</tasks>'], 'tokens');
  parts = vertcat (parts{:}, cell (0, 3));
  tasks = struct ('state', cell (1, numel (names)), 'word', '');
  for k = 1:numel (names)
    tasks(k) = ofArray (parts(strcmp (parts(:, 1), names{k}), 2:3), sizes(k));
  end
end

function tasks = ofArray (parts, n)
  tasks = struct ('state', repmat ('-', 1, n), ...
                  'word', {repmat({'not in qstat any more'}, 1, n)});
  for k = 1:rows (parts)
    t = numbersOf (parts{k, 2});
    t = t(t <= n);
    tasks.state(t) = 'r';
    if any (parts{k, 1} == 'q')
      tasks.state(t) = 'p';
    end
    tasks.word(t) = parts(k, 1);
    if any (parts{k, 1} == 'E')
      tasks.word(t) = {[parts{k, 1}, ' (see qstat -explain E)']};
    end
  end
end

% '7', '2-9:1' or '1,4'
function numbers = numbersOf (text)
  numbers = [];
  for part = strsplit (text, ',')
    ends = sscanf (part{1}, '%d-%d:%d')';
    ends(end + 1:2) = ends(end);
    numbers = [numbers, ends(1):ends(2)];
  end
end

%!test
%! job = ['<job_list>\n<JB_name>%s</JB_name>\n<state>%s</state>\n', ...
%!        '<tasks>%s</tasks>\n</job_list>\n'];
%! list = [sprintf(job, 'a', 'r', '1'), sprintf(job, 'b', 'r', '1'), ...
%!         sprintf(job, 'a', 'qw', '3-4:1'), sprintf(job, 'a', 'Eqw', '6'), ...
%!         sprintf(job, 'a', 'dr', '7')];
%! tidy = slurmFake ('', ['echo ''', list, ''''], {'qsub', 'qstat'});
%! [ok, ~, tasks] = gridengineLook ({'a', 'c'}, [7, 1]);
%! assert (ok);
%! assert ({tasks.state}, {'r-pp-pr', '-'});
%! assert (tasks(1).word{6}, 'Eqw (see qstat -explain E)');
%!test
%! tidy = slurmFake ('', 'echo "no contact" >&2; exit 1', {'qsub', 'qstat'});
%! [ok, text] = gridengineLook ({'a'}, 1);
%! assert (! ok);
%! assert (text, "no contact\n");
