% NEWQUEUE  The executor of a queue, of what the queue alone knows.
%
% CALL: QUEUE = newQueue (OWN)
%
%   OWN    scalar struct
%     name      name of the executor (text)
%     title     name of the queue as users write it (text)
%     words     1 x n cell, names of its fields that hold a text
%     option    regular expression that an element of extra must match; its
%               first token is the option's name
%     example   one such element (text)
%     reserved  1 x m cell of options that DEcalioc sets itself
%     isShort   logical: the program completes options that are not written in
%               full
%     program   program that submits (text)
%     task      {name of the environment variable that holds the number of the
%               task, of the one that holds the job's number}
%     start     [N, FAULT] = start (): tasks that an array may have at most;
%               why the queue cannot be used here, '' = it can
%     submit    [OK, TEXT, ISPASSING] = submit (BATCH, OPT, TASK): submits one
%               job array; what the program said; it may take it later. BATCH is
%               an element of FLIGHT.batches (batchAttach), TASK the program
%               that a task runs, and its arguments (1 x n cell)
%     look      [OK, TEXT, TASKS] = look (NAMES, SIZES), see slurmLook
%     cancel    [OK, TEXT] = cancel (NAMES): empties the queue of these arrays
%   QUEUE  OWN with check, isHere, sets, execute (see describeExecutor) and
%     options   OPT = options (CASE.options) fills in what the user left out of
%               Input.<name>
%     send      [VERDICT, TEXT] = send (BATCH, OPT, TASK): 'sent'; 'later' (the
%               queue cannot be reached); 'refused' (partition, limits ...)
%
% OPT is a struct with
%     extra        1 x n cell of further options of the program that submits
%     before       1 x n cell of shell commands that a job carries out first
%     time         time limit of a job (min), NaN = from the model's time limit
%     maxInFlight  runs that are submitted and not ended, at most; 200
%     sets         parameter sets tried at a time after the plan; 8
%     poll         time between two looks at the queue (s); 10
%     grace        how long to wait for the files of a run that the queue says
%                  has ended (s), longer than the attribute cache of a network
%                  file system; 30
%     and those of OWN.words, '' = the queue's default

function queue = newQueue (own)
  queue = own;
  queue.isHere = false;
  queue.check = @(given) checkQueue (given, own);
  queue.options = @(options) optionsOf (options, own);
  queue.sets = @(options) optionsOf (options, own).sets;
  queue.send = @(batch, opt, task) sendOnce (own, batch, opt, task);
  queue.execute = @(jobs, Case, report) batchExecute (queue, jobs, Case, ...
                                                      report);
end

% The program may give up on a job that the queue did accept: the queue is asked
% before a batch is called not sent.
function [verdict, text] = sendOnce (own, batch, opt, task)
  [ok, text, isPassing] = own.submit (batch, opt, task);
  text = strtrim (text);
  verdict = 'sent';
  if ~ok
    [answers, ~, tasks] = own.look ({batch.name}, batch.n);
    isThere = answers && any (tasks.state ~= '-');
    if ~answers || (~isThere && isPassing)
      verdict = 'later';
    elseif ~isThere
      verdict = 'refused';
    end
  end
end

function opt = optionsOf (options, own)
  given = givenField (options, own.name, []);
  opt = struct ('extra', {{}}, 'before', {{}}, 'time', NaN, ...
                'maxInFlight', 200, 'sets', 8, 'poll', 10, 'grace', 30);
  for word = own.words
    opt.(word{1}) = '';
  end
  if isempty (given)
    return
  end
  for name = fieldnames (given)'
    if ~isempty (given.(name{1}))
      opt.(name{1}) = given.(name{1});
    end
  end
  for name = {'extra', 'before'}
    opt.(name{1}) = cellstr (opt.(name{1}))(:)';
  end
end

% GIVEN anything; [] or a struct with the fields of OPT, each optional.
function p = checkQueue (given, own)
  p = checkFault ();
  field = ['Input.', own.name];
  if checkIs ('nothing', given)
    return
  end
  if ~checkIs ('struct', given)
    p = checkFault ('notStruct', field, 'one struct', checkShow (given), ...
                    sprintf ('Write %s.%s = ''name''; and so on.', field, ...
                             own.words{1}));
    return
  end
  rules = {'time', 'badQueueTime', 1, 1e7, 'number', false, ...
           'Set the minutes that one job may take.'; ...
           'poll', 'badQueueWait', 0, 1e5, 'number', false, ...
           'Set the seconds between two looks at the queue.'; ...
           'grace', 'badQueueWait', 0, 1e5, 'number', false, ...
           'Set the seconds that files may need to appear.'; ...
           'sets', 'badQueueLimit', 1, 1e6, 'integer', false, ...
           'Set the parameter sets tried at a time after the plan.'; ...
           'maxInFlight', 'badQueueLimit', 1, 1e6, 'integer', false, ...
           'Set the number of jobs that may wait or run at a time.'};
  known = [own.words, {'extra', 'before'}];
  p = [checkFields(given, field, known, rules), ...
       checkExtra(given, field, own), checkBefore(given, field)];
  for word = own.words
    p = [p, checkWord(given, field, word{1})];
  end
end

function p = checkWord (given, prefix, name)
  p = checkFault ();
  if ~isfield (given, name) || checkIs ('nothing', given.(name))
    return
  end
  word = given.(name);
  plain = ['A':'Z', 'a':'z', '0':'9', '_-+.,:@/'];
  if ~checkIs ('text', word) || ~all (ismember (word, plain)) || ...
      word(1) == '-'
    p = checkFault ('badQueueName', [prefix, '.', name], ...
                    'a name as the queue shows it', checkShow (word), ...
                    'Write it without blanks, or leave it out.');
  end
end

function [p, texts] = checkTexts (given, prefix, name, reason, cure)
  p = checkFault ();
  texts = cell (1, 0);
  if ~isfield (given, name) || checkIs ('nothing', given.(name))
    return
  end
  texts = given.(name);
  if ischar (texts)
    texts = {texts};
  end
  if ~iscell (texts) || ~all (cellfun (@(w) checkIs ('text', w), texts(:)'))
    p = checkFault (reason, [prefix, '.', name], ...
                    'a text or a cell of texts', ...
                    checkShow (given.(name)), cure);
    texts = cell (1, 0);
  end
  texts = texts(:)';
end

% What DEcalioc sets itself is how the runs are found again and kept apart.
function p = checkExtra (given, prefix, own)
  cure = sprintf ('Write for example %s.extra = ''%s'';', prefix, own.example);
  [p, words] = checkTexts (given, prefix, 'extra', 'badQueueExtra', cure);
  for k = 1:numel (words)
    name = regexp (words{k}, own.option, 'tokens', 'once');
    isBad = isempty (name) || any (words{k} == 0 | words{k} == "\n");
    if ~isBad && own.isShort
      isBad = any (strncmp (name{1}, own.reserved, numel (name{1})));
    elseif ~isBad
      isBad = any (strcmp (name{1}, own.reserved));
    end
    if isBad
      p(end + 1) = checkFault ('badQueueExtra', ...
                               sprintf ('%s.extra{%d}', prefix, k), ...
                               ['one option, which DEcalioc does not set ' ...
                                'itself'], checkShow (words{k}), cure);
    end
  end
end

function p = checkBefore (given, prefix)
  cure = sprintf (['Write for example %s.before = {''module load ' ...
                   'openmpi''};'], prefix);
  p = checkTexts (given, prefix, 'before', 'badQueueBefore', cure);
end

%!test
%! queue = newQueue (struct ('name', 'q', 'words', {{'group'}}));
%! assert (queue.options (struct ('q', struct ('group', 'a'))).group, 'a');
%! assert (queue.options (struct ()).group, '');
%!test
%! % not accepted: the queue has it all the same, does not answer, has it not
%! own = struct ('name', 'q', 'words', {{}});
%! said = {};
%! for state = 'p?-'
%!   own.submit = @(batch, opt, task) deal (false, "no\n", true);
%!   own.look = @(names, sizes) deal (state ~= '?', '', ...
%!                                    struct ('state', state));
%!   said{end + 1} = newQueue (own).send (struct ('name', 'a', 'n', 1), 0, 0);
%! end
%! assert (said, {'sent', 'later', 'later'});
%! own.submit = @(batch, opt, task) deal (false, "no\n", false);
%! queue = newQueue (own);
%! [verdict, text] = queue.send (struct ('name', 'a', 'n', 1), 0, 0);
%! assert ({verdict, text}, {'refused', 'no'});
%!function p = check (given, own)
%!  p = newQueue (own).check (given);
%!endfunction
%!shared own, ids
%! own = struct ('name', 'q', 'words', {{'partition', 'account'}}, ...
%!               'example', '--mem=2G', ...
%!               'option', '^--([a-z-]+)(=.*)?$', 'isShort', true, ...
%!               'reserved', {{'array', 'job-name'}});
%! ids = @(p) strrep ({p.id}, 'DEcalioc:checkCase:', '');
%!assert (isempty (check (struct ('partition', 'main', 'time', 30, ...
%!        'before', {{'module load a'}}, 'extra', '--qos=a b'), own)))
%!assert (isempty (check ([], own)))
%!assert (ids (check (3, own)), {'notStruct'})
%!assert (ids (check (struct ('tiem', 1), own)), {'unknownField'})
%!assert (ids (check (struct ('account', 'a;b'), own)), ...
%!        {'badQueueName'})
%!assert (ids (check (struct ('extra', {{1}}), own)), ...
%!        {'badQueueExtra'})
%!assert (ids (check (struct ('before', 7), own)), ...
%!        {'badQueueBefore'})
%!assert (ids (check (struct ('poll', NaN), own)), {'badQueueWait'})
%!assert (ids (check (struct ('sets', 0), own)), {'badQueueLimit'})
%!test
%! % reserved, also abbreviated where the program completes names; a file name
%! bad = @(text) check (struct ('extra', {{'--qos=a', text}}), own);
%! assert (ids (bad ('--array=1-3')), {'badQueueExtra'});
%! assert (ids (bad ('--job=x')), {'badQueueExtra'});
%! assert (ids (bad ('job.sh')), {'badQueueExtra'});
%! own.isShort = false;
%! assert (isempty (check (struct ('extra', '--job=x'), own)));
%!function o = options (given, words)
%!  own = struct ('name', 'q', 'words', {words});
%!  o = newQueue (own).options (struct ('q', given));
%!endfunction
%!test
%! o = options (struct (), {'partition'});
%! assert (o.partition, '');
%! assert (isempty (o.extra));
%! assert ([o.time, o.maxInFlight, o.sets, o.poll, o.grace], ...
%!         [NaN, 200, 8, 10, 30]);
%!test
%! o = options (struct ('time', 90, 'extra', {{'--mem=2G'; '--qos=a'}}, ...
%!                      'before', 'module load a', 'poll', []), {});
%! assert (o.extra, {'--mem=2G', '--qos=a'});
%! assert (o.before, {'module load a'});
%! assert ([o.time, o.poll], [90, 10]);
