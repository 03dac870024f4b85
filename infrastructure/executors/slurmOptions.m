% SLURMOPTIONS  Fills and checks what the user said about Slurm.
%
% CALL: OPT = slurmOptions (GIVEN)
%
%   GIVEN  struct Input.slurm as the user wrote it; every field may be missing
%          or empty
%   OPT    struct with all fields:
%     partition    text, '' = Slurm's default
%     account      text, '' = Slurm's default
%     time         time limit of a job (min), NaN = from the model's time limit
%     extra        1 x n cell of further options of sbatch, '--name' or
%                  '--name=value' each; {}
%     maxInFlight  runs that are submitted and not ended, at most; 200
%     poll         time between two looks at the queue (s); 10
%     grace        how long to wait for the files of a run that Slurm says has
%                  ended (s), longer than the attribute cache of a network
%                  file system; 30
%
% Errors: DEcalioc:slurmOptions:unknownName, badType, badValue
%
% See also: executeSlurm

function opt = slurmOptions (given)
  opt = struct ('partition', '', 'account', '', 'time', NaN, ...
                'extra', {{}}, 'maxInFlight', 200, 'poll', 10, 'grace', 30);
  if isempty (given)
    given = struct ();
  end
  require (isstruct (given) && isscalar (given), 'badType', ...
           'slurm', 'a struct', class (given));
  names = fieldnames (given);
  for k = 1:numel (names)
    require (isfield (opt, names{k}), 'unknownName', 'slurm', ...
             ['a struct of ', strjoin(fieldnames (opt)', ', ')], names{k});
    if ~isempty (given.(names{k}))
      opt.(names{k}) = given.(names{k});
    end
  end
  opt.partition = checkWord ('partition', opt.partition);
  opt.account = checkWord ('account', opt.account);
  opt.extra = checkExtra (opt.extra);
  checkNumber ('time', opt.time, 1, true);
  checkNumber ('maxInFlight', opt.maxInFlight, 1, false);
  checkNumber ('poll', opt.poll, 0, false);
  checkNumber ('grace', opt.grace, 0, false);
end

function require (ok, reason, name, wanted, got)
  if ~ok
    error (['DEcalioc:slurmOptions:', reason], ...
           ['slurmOptions: Input.%s must be %s, got %s. The fields are ', ...
            'described in docs/slurm.md.'], name, wanted, got);
  end
end

function word = checkWord (name, word)
  require (ischar (word) && rows (word) <= 1, 'badType', ...
           ['slurm.', name], 'text', class (word));
  require (isempty (regexp (word, '[^\w.,:@+-]|^-', 'once')), 'badValue', ...
           ['slurm.', name], 'letters, digits and . , : @ + - only', ...
           sprintf ('"%s"', word));
end

function extra = checkExtra (extra)
  if ischar (extra) && ~isempty (extra)
    extra = {extra};
  end
  if isempty (extra)
    extra = {};
  end
  require (iscellstr (extra), 'badType', 'slurm.extra', ...
           'a cell of texts', class (extra));
  extra = extra(:)';
  % these are how the runs are found again and kept apart
  ours = {'array', 'job-name', 'wrap', 'wait', 'requeue', 'no-requeue', ...
          'output', 'error', 'input', 'chdir', 'parsable', 'test-only', ...
          'help', 'usage', 'version', 'time', 'ntasks', 'nodes', ...
          'cpus-per-task', 'clusters', 'uid', 'open-mode', 'export'};
  for k = 1:numel (extra)
    name = regexp (extra{k}, '^--([a-z][a-z0-9-]*)(=[^\n]*)?$', ...
                   'tokens', 'once');
    require (~isempty (name) && ~any (extra{k} == 0), 'badValue', ...
             sprintf ('slurm.extra{%d}', k), ...
             'one long option, --name or --name=value', ...
             sprintf ('"%s"', extra{k}));
    clash = strncmp (name{1}, ours, numel (name{1}));
    require (~any (clash), 'badValue', sprintf ('slurm.extra{%d}', k), ...
             'an option that DEcalioc does not set itself', ...
             sprintf ('"%s"', extra{k}));
  end
end

function checkNumber (name, value, least, isOptional)
  ok = isnumeric (value) && isscalar (value) && isreal (value);
  require (ok, 'badType', ['slurm.', name], 'a number', ...
           sprintf ('%s of %d elements', class (value), numel (value)));
  ok = (isOptional && isnan (value)) || (value >= least && value < Inf);
  require (ok, 'badValue', ['slurm.', name], ...
           sprintf ('a finite number >= %g', least), sprintf ('%g', value));
end

%!test
%! o = slurmOptions ([]);
%! assert ({o.partition, o.account}, {'', ''});
%! assert (isempty (o.extra));
%! assert ([o.time, o.maxInFlight, o.poll, o.grace], [NaN, 200, 10, 30]);
%!test
%! o = slurmOptions (struct ('time', 90, 'extra', {{'--mem=2G'; '--qos=a b'}}));
%! assert (o.extra, {'--mem=2G', '--qos=a b'});
%! assert (o.time, 90);
%!assert (slurmOptions (struct ('poll', [], 'account', '')).poll, 10)
%!error id=DEcalioc:slurmOptions:unknownName slurmOptions (struct ('tiem', 1))
%!error id=DEcalioc:slurmOptions:badType slurmOptions (3)
%!error id=DEcalioc:slurmOptions:badType slurmOptions (struct ('poll', 'a'))
%!error id=DEcalioc:slurmOptions:badType slurmOptions (struct ('account', 7))
%!error id=DEcalioc:slurmOptions:badType slurmOptions (struct ('extra', 7))
%!error id=DEcalioc:slurmOptions:badValue slurmOptions (struct ('time', 0))
%!error id=DEcalioc:slurmOptions:badValue slurmOptions (struct ('poll', NaN))
%!error id=DEcalioc:slurmOptions:badValue
%! slurmOptions (struct ('partition', 'a;rm -r x'));
%!error id=DEcalioc:slurmOptions:badValue
%! slurmOptions (struct ('extra', {{'job.sh'}}));
%!error id=DEcalioc:slurmOptions:badValue
%! slurmOptions (struct ('extra', {{'--array=1-9'}}));
%!error id=DEcalioc:slurmOptions:badValue
%! % sbatch completes abbreviated names
%! slurmOptions (struct ('extra', {{'--job=x'}}));
