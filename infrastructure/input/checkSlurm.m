% CHECKSLURM  Checks Input.slurm, what the cluster is asked for.
%
% CALL: P = checkSlurm (SLURM)
%
%   SLURM  anything; [] or a scalar struct with the fields partition, account,
%          time (min), extra and maxInFlight, poll
%          (s) and grace (s), each optional
%   P      1 x n problems, see checkProblem
%
% Reasons: notStruct unknownField badSlurmName badSlurmTime badSlurmExtra
% badSlurmLimit badSlurmWait
%
% See also: checkInputFields, executeSlurm

function p = checkSlurm (slurm)
  p = checkProblem ();
  if checkIs ('nothing', slurm)
    return
  end
  if ~checkIs ('struct', slurm)
    p = checkProblem ('notStruct', 'Input.slurm', 'one struct', ...
                      checkShow (slurm), ...
                      'Write Input.slurm.partition = ''name''; and so on.');
    return
  end
  rules = {'time', 'badSlurmTime', 1, 1e7, 'number', false, ...
           'Set the minutes that one job may take.'; ...
           'poll', 'badSlurmWait', 0, 1e5, 'number', false, ...
           'Set the seconds between two looks at the queue.'; ...
           'grace', 'badSlurmWait', 0, 1e5, 'number', false, ...
           'Set the seconds that files may need to appear.'; ...
           'maxInFlight', 'badSlurmLimit', 1, 1e6, 'integer', false, ...
           'Set the number of jobs that may wait or run at a time.'};
  known = {'partition', 'account', 'time', 'extra', 'maxInFlight', ...
           'poll', 'grace'};
  p = [checkFields(slurm, 'Input.slurm', known), ...
       checkWord(slurm, 'partition'), checkWord(slurm, 'account'), ...
       checkScalars(slurm, 'Input.slurm', rules), checkExtra(slurm)];
  if isempty (p)
    p = checkRest (slurm);
  end
end

% The executor knows best which options it cannot pass on.
function p = checkRest (slurm)
  p = checkProblem ();
  try
    slurmOptions (slurm);
  catch err
    p = checkProblem ('badSlurmExtra', 'Input.slurm', ...
                      'options that DEcalioc can pass on to sbatch', ...
                      err.message, 'See docs/slurm.md.');
  end
end

function p = checkWord (slurm, name)
  p = checkProblem ();
  if ~isfield (slurm, name) || checkIs ('nothing', slurm.(name))
    return
  end
  word = slurm.(name);
  plain = ['A':'Z', 'a':'z', '0':'9', '_-+.,:@/'];
  if ~checkIs ('text', word) || ~all (ismember (word, plain)) || ...
      word(1) == '-'
    p = checkProblem ('badSlurmName', ['Input.slurm.', name], ...
                      'a name as sinfo or sacctmgr shows it', ...
                      checkShow (word), ...
                      'Write it without blanks, or leave it out.');
  end
end

function p = checkExtra (slurm)
  p = checkProblem ();
  if ~isfield (slurm, 'extra') || checkIs ('nothing', slurm.extra)
    return
  end
  words = slurm.extra;
  if ischar (words)
    words = {words};
  end
  if ~iscell (words) || ...
      ~all (cellfun (@(w) checkIs ('text', w), words(:)')) || ...
      ~all (cellfun (@(w) w(1) == '-', words(:)'))
    p = checkProblem ('badSlurmExtra', 'Input.slurm.extra', ...
                      'options of sbatch, as a text or a cell of texts', ...
                      checkShow (slurm.extra), ...
                      'Write for example Input.slurm.extra = ''--mem=2G'';');
  end
end

%!assert (isempty (checkSlurm (struct ('partition', 'main', 'time', 30))))
%!assert (isempty (checkSlurm ([])))
%!assert (checkSlurm (struct ('extra', '--array=1-3')).id, ...
%!        'DEcalioc:checkCase:badSlurmExtra')
%!assert (checkSlurm (3).id, 'DEcalioc:checkCase:notStruct')
%!assert (checkSlurm (struct ('account', 'a;b')).id, ...
%!        'DEcalioc:checkCase:badSlurmName')
%!assert (checkSlurm (struct ('extra', {{1}})).id, ...
%!        'DEcalioc:checkCase:badSlurmExtra')
