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

% STATES 1 x N char, see batchJudge, and WORDS: STATE (reason) as Slurm has it,
% of the array NAME. A line of squeue may stand for several tasks ('7', '2-5,9',
% '2-8%3'), 'N/A' (cancelled before the array was split up) for all not listed.
% A task that is listed twice (submitted twice, see batchTask.sh) has the state
% of the one that has not ended; what a future Slurm invents is running.
function [states, words] = slurmParse (text, name, n)
  lines = regexp (text, '^([^|\n]+)\|([^|\n]*)\|([^|\n]*)\|([^\n]*)$', ...
                  'tokens', 'lineanchors');
  lines = vertcat (lines{:}, cell (0, 4));
  lines = lines(strcmp (lines(:, 1), name), 2:4);

  % what is written later counts: live tasks come last
  isWhole = strcmp (lines(:, 1), 'N/A');
  letters = cellfun (@letterOf, lines(:, 2));
  isLive = reshape (letters == 'p' | letters == 'r', [], 1);
  [~, order] = sort (2 * isLive - isWhole);
  lines = splitRanges (lines(order, :), n);
  tasks = str2double (lines(:, 1));
  isOurs = tasks >= 1 & tasks <= n;
  states = repmat ('-', 1, n);
  words = repmat ({''}, 1, n);
  states(tasks(isOurs)) = cellfun (@letterOf, lines(isOurs, 2));
  words(tasks(isOurs)) = cellfun (@inWords, lines(isOurs, 2), ...
                                  lines(isOurs, 3), 'UniformOutput', false);
end

function letter = letterOf (state)
  ended = {'BOOT_FAIL', 'CANCELLED', 'COMPLETED', 'FAILED', 'NODE_FAIL', ...
           'OUT_OF_MEMORY', 'PREEMPTED', 'REVOKED'};
  if any (strcmp (state, {'TIMEOUT', 'DEADLINE'}))
    letter = 't';
  elseif any (strcmp (state, ended))
    letter = 'e';
  elseif strcmp (state, 'PENDING')
    letter = 'p';
  else
    letter = 'r';
  end
end

function text = inWords (state, reason)
  text = state;
  if ~any (strcmp (reason, {'', 'None'}))
    text = sprintf ('%s (%s)', state, reason);
  end
end

function lines = splitRanges (lines, n)
  parts = mat2cell (lines, ones (1, rows (lines)), columns (lines));
  for k = find (isnan (str2double (lines(:, 1)')))
    tasks = taskNumbers (lines{k, 1}, n);
    parts{k} = repmat (lines(k, :), numel (tasks), 1);
    parts{k}(:, 1) = arrayfun (@num2str, tasks(:), 'UniformOutput', false);
  end
  lines = vertcat (cell (0, columns (lines)), parts{:});
end

function tasks = taskNumbers (text, n)
  if strcmp (text, 'N/A')
    tasks = 1:n;
    return
  end
  text = regexprep (text, '%.*$|[\[\]]', '');
  tasks = [];
  parts = strsplit (text, ',');
  for k = 1:numel (parts)
    ends = sscanf (parts{k}, '%d-%d')';
    if ~isempty (ends)
      tasks = [tasks, ends(1):ends(end)];
    end
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
%!function [states, words] = parsed (text, name, n)
%!  tidy = slurmFake ('false', sprintf ("cat <<'END'\n%sEND", text));
%!  [~, ~, tasks] = slurmLook ({name}, n);
%!  states = tasks.state;
%!  words = tasks.word;
%!endfunction
%!test
%! text = sprintf (["a|1|RUNNING|None\nb|1|FAILED|NonZeroExitCode\n", ...
%!                  "a|3-4|CANCELLED|None\na|[6-8%%2]|PENDING|Priority\n"]);
%! [s, w] = parsed (text, 'a', 8);
%! assert (s, 'r-ee-ppp');
%! assert (w([1, 2, 6]), {'RUNNING', '', 'PENDING (Priority)'});
%! assert (parsed (text, 'b', 2), 'e-');
%! assert (parsed ('', 'b', 2), '--');
%!test
%! % cancelled before it was split; one task had run before
%! text = sprintf ("a|2|TIMEOUT|None\na|N/A|CANCELLED|JobHeldUser\n");
%! assert (parsed (text, 'a', 3), 'ete');
%!test
%! % submitted twice: the one that goes on counts
%! text = sprintf ("a|1|RUNNING|None\na|1|FAILED|NonZeroExitCode\n");
%! assert (parsed (text, 'a', 1), 'r');
%! text = sprintf ("a|1|FAILED|NonZeroExitCode\na|1|PENDING|None\n");
%! assert (parsed (text, 'a', 1), 'p');
%!assert (parsed ("a|1|COMPLETING|None\n", 'a', 1), 'r')
