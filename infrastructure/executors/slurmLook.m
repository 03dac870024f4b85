% SLURMLOOK  Asks Slurm once about all arrays of a plan.
%
% CALL: [OK, TEXT, TASKS] = slurmLook (NAMES, SIZES)
%
%   NAMES  1 x b cell of job names
%   SIZES  1 x b, tasks of each array
%   OK     logical; false = no answer, which says nothing about the jobs
%   TEXT   what squeue said
%   TASKS  1 x b struct array: state (1 x n char, see batchJudge) and word (1 x
%          n cell, Slurm's own words) of each task
%
% Arrays are asked for by name, not by number: an unknown number is an error
% for squeue, an unknown name is not. Ended jobs are listed as long as the
% controller remembers them (MinJobAge).
%
% See also: slurmParse, batchExecute

function [ok, text, tasks] = slurmLook (names, sizes)
  command = ['timeout 60 squeue --noheader --array --states=all ' ...
             '--user="$(id -u)" --format="%j|%K|%T|%r" --name='];
  [status, text] = system ([command, shellQuote(strjoin (names, ',')), ...
                            ' 2>&1']);
  ok = status == 0;
  tasks = struct ('state', cell (1, numel (names)), 'word', '');
  for k = 1:numel (names)
    [tasks(k).state, tasks(k).word] = slurmParse (text, names{k}, sizes(k));
  end
end

%!test
%! tidy = slurmFake ('false', 'echo "$@"');
%! [ok, text] = slurmLook ({'a', 'b'}, [1, 1]);
%! assert (ok);
%! assert (! isempty (strfind (text, '--name=a,b')));
%!test
%! tidy = slurmFake ('false', 'echo "no contact" >&2; exit 1');
%! [ok, text] = slurmLook ({'a'}, 1);
%! assert (! ok);
%! assert (text, "no contact\n");
