% NEWQUEUE  The executor of a queue, of what the queue alone knows.
%
% CALL: QUEUE = newQueue (TRAITS)
%
%   TRAITS    scalar struct
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
%     call      WORDS = call (BATCH, OPT, TASK): the command that submits one job
%               array (1 x m cell), see submit
%     submit    [OK, TEXT, ISPASSING] = submit (BATCH, OPT, TASK): submits one
%               job array; what the program said; it may take it later. BATCH is
%               an element of QUEUESTATE.batches (batchAttach), TASK the program
%               that a task runs, and its arguments (1 x n cell)
%     look      [OK, TEXT, TASKS] = look (NAMES, SIZES): asks once about arrays
%               (1 x b cell of names, numbers of tasks). OK: false = no answer,
%               which says nothing about the jobs; TEXT what was said; TASKS 1 x
%               b struct: state (1 x n char, see pollQueue) and word (1 x n
%               cell, the queue's own words) of each task
%     cancel    [OK, TEXT] = cancel (NAMES): empties the queue of these arrays
%   QUEUE  TRAITS with check, isHere, sets, execute (see describeExecutor),
%     preview   TEXT = preview (JOBS, CASE), see batchPreview
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
%     and those of TRAITS.words, '' = the queue's default

function queue = newQueue (traits)
  queue = traits;
  queue.isHere = false;
  queue.check = @(given) checkQueue (given, traits);
  queue.options = @(options) optionsOf (options, traits);
  queue.sets = @(options) optionsOf (options, traits).sets;
  queue.send = @(batch, opt, task) sendOnce (traits, batch, opt, task);
  queue.preview = @(jobs, Case) batchPreview (queue, jobs, Case);
  queue.execute = @(jobs, Case, report) batchExecute (queue, jobs, Case, ...
                                                      report);
end

% The program may give up on a job that the queue did accept: the queue is asked
% before a batch is called not sent.
function [verdict, text] = sendOnce (traits, batch, opt, task)
  [ok, text, isPassing] = traits.submit (batch, opt, task);
  text = strtrim (text);
  verdict = 'sent';
  if ~ok
    [answers, ~, tasks] = traits.look ({batch.name}, batch.n);
    isThere = answers && any (tasks.state ~= '-');
    if ~answers || (~isThere && isPassing)
      verdict = 'later';
    elseif ~isThere
      verdict = 'refused';
    end
  end
end

function opt = optionsOf (options, traits)
  given = givenField (options, traits.name, []);
  opt = struct ('extra', {{}}, 'before', {{}}, 'time', NaN, ...
                'maxInFlight', 200, 'sets', 8, 'poll', 10, 'grace', 30);
  for word = traits.words
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
function p = checkQueue (given, traits)
  p = checkFault ();
  field = ['Input.', traits.name];
  if isKind ('nothing', given)
    return
  end
  if ~isKind ('struct', given)
    p = checkFault ('notStruct', field, 'one struct', describeValue (given), ...
                    sprintf ('Write %s.%s = ''name''; and so on.', field, ...
                             traits.words{1}));
    return
  end
  forExtra = sprintf ('Write for example %s.extra = ''%s'';', field, ...
                      traits.example);
  forBefore = sprintf (['Write for example %s.before = {''module load ' ...
                        'openmpi''};'], field);
  texts = 'a text or a cell of texts';
  rules = {'time', 'badQueueTime', 1, 1e7, 'number', false, ...
           'Set the minutes that one job may take.'; ...
           'poll', 'badQueueWait', 0, 1e5, 'number', false, ...
           'Set the seconds between two looks at the queue.'; ...
           'grace', 'badQueueWait', 0, 1e5, 'number', false, ...
           'Set the seconds that files may need to appear.'; ...
           'sets', 'badQueueLimit', 1, 1e6, 'integer', false, ...
           'Set the parameter sets tried at a time after the plan.'; ...
           'maxInFlight', 'badQueueLimit', 1, 1e6, 'integer', false, ...
           'Set the number of jobs that may wait or run at a time.'; ...
           'extra', 'badQueueExtra', texts, @areTexts, 'other', false, ...
           forExtra; ...
           'before', 'badQueueBefore', texts, @areTexts, 'other', false, ...
           forBefore};
  for word = traits.words
    rules(end + 1, :) = {word{1}, 'badQueueName', ...
                         'a name as the queue shows it', @isWord, 'other', ...
                         false, 'Write it without blanks, or leave it out.'};
  end
  p = checkFields (given, field, {}, rules);
  if isfield (given, 'extra') && areTexts (given.extra)
    p = [p, checkExtra(cellstr (given.extra)(:)', field, traits, forExtra)];
  end
end

function yes = isWord (word)
  plain = ['A':'Z', 'a':'z', '0':'9', '_-+.,:@/'];
  yes = isKind ('text', word) && all (ismember (word, plain)) && ...
        word(1) ~= '-';
end

function yes = areTexts (texts)
  if ischar (texts)
    texts = {texts};
  end
  yes = iscell (texts) && all (cellfun (@(w) isKind ('text', w), texts(:)));
end

% What DEcalioc sets itself is how the runs are found again and kept apart.
function p = checkExtra (words, field, traits, cure)
  p = checkFault ();
  names = regexp (words, traits.option, 'tokens', 'once');
  isSame = @(name) any (strcmp (name, traits.reserved));
  if traits.isShort
    isSame = @(name) any (strncmp (name, traits.reserved, numel (name)));
  end
  for k = 1:numel (words)
    if isempty (names{k}) || isSame (names{k}{1})
      p(end + 1) = checkFault ('badQueueExtra', ...
                               sprintf ('%s.extra{%d}', field, k), ...
                               ['one option, which DEcalioc does not set ' ...
                                'itself'], describeValue (words{k}), cure);
    end
  end
end

%!test
%! % not accepted: the queue has it all the same, does not answer, has it not
%! traits = struct ('name', 'q', 'words', {{}});
%! verdicts = {};
%! for state = 'p?-'
%!   traits.submit = @(batch, opt, task) deal (false, "no\n", true);
%!   traits.look = @(names, sizes) deal (state ~= '?', '', ...
%!                                    struct ('state', state));
%!   queue = newQueue (traits);
%!   verdicts{end + 1} = queue.send (struct ('name', 'a', 'n', 1), 0, 0);
%! end
%! assert (verdicts, {'sent', 'later', 'later'});
%! traits.submit = @(batch, opt, task) deal (false, "no\n", false);
%! queue = newQueue (traits);
%! [verdict, text] = queue.send (struct ('name', 'a', 'n', 1), 0, 0);
%! assert ({verdict, text}, {'refused', 'no'});

%!test
%! traits = struct ('name', 'q', 'words', {{'partition', 'account'}}, ...
%!               'example', '--mem=2G', 'option', ...
%!               '^--([a-z-]+)(=.*)?$', 'isShort', true, ...
%!               'reserved', {{'array', 'job-name'}});
%! check = newQueue (traits).check;
%! assert (isempty (check ([])));
%! assert (isempty (check (struct ('partition', 'main', 'time', 30, ...
%!                                 'before', {{'module load a'}}, ...
%!                                 'extra', '--qos=a b'))));
%! % reserved, also abbreviated where the program completes names; a file name
%! for bad = {3, 'notStruct'; struct('tiem', 1), 'unknownField'; ...
%!            struct('account', 'a;b'), 'badQueueName'; ...
%!            struct('extra', {{1}}), 'badQueueExtra'; ...
%!            struct('before', 7), 'badQueueBefore'; ...
%!            struct('poll', NaN), 'badQueueWait'; ...
%!            struct('sets', 0), 'badQueueLimit'; ...
%!            struct('extra', {{'--qos=a', '--array=3'}}), 'badQueueExtra'; ...
%!            struct('extra', '--job=x'), 'badQueueExtra'; ...
%!            struct('extra', 'job.sh'), 'badQueueExtra'}'
%!   assert ({check(bad{1}).id}, {['DEcalioc:checkCase:', bad{2}]});
%! end
%! traits.isShort = false;
%! assert (isempty (newQueue (traits).check (struct ('extra', '--job=x'))));

%!test
%! queue = newQueue (struct ('name', 'q', 'words', {{'partition'}}));
%! o = queue.options (struct ());
%! assert ({o.partition, o.extra}, {'', {}});
%! assert ([o.time, o.maxInFlight, o.sets, o.poll, o.grace], ...
%!         [NaN, 200, 8, 10, 30]);
%! o = queue.options (struct ('q', struct ('time', 90, 'poll', [], ...
%!   'partition', 'a', 'before', 'module load a', ...
%!   'extra', {{'--mem=2G'; '--qos=a'}})));
%! assert (o.extra, {'--mem=2G', '--qos=a'});
%! assert ({o.partition, o.before}, {'a', {'module load a'}});
%! assert ([o.time, o.poll], [90, 10]);

% SPDX-License-Identifier: GPL-3.0-only
