% TWOUSERS  Two users, two cases, one store: kills, cancels, forgets, changes.
%
% CALL: octave-cli benchmarks/twoUsers.m [EVENTS [SEED [PAIRS [MINUTES]]]]
%
%   EVENTS   how many (default 60), a quarter of them for the first pair
%   SEED     of what happens and when (default 1), as far as a machine repeats
%            itself
%   PAIRS    'apart shared' (default), or one of them
%   MINUTES  after which a pair gets no more events (default: none)
%
% Two cases (userCase) work at the same time on one store (setgid, umask 002).
% As root they belong to two users (numbers 1001 and 1002, group 2000, setpriv),
% else both to the one who calls. An event hits one of them at a random moment,
% up to six runs after the last one:
%   kill    SIGKILL of its Octave and all workers at once
%   cancel  decalioc cancel
%   forget  decalioc forget beside its start: all its runs, one, or --back
%   change  measured.csv gets other values, a point more, a remark, or is again
%           what it was
% Then it is started again, if it does not work any more. After each event the
% store (storeWatch) and the other case are looked at: its Octave, lock, files,
% and which of its runs are out of use. In the end measured.csv is what it was,
% both run to their ends, and once more, which must make no run.
%
% Two pairs of cases. 'apart': a fixed variable differs, so they share no run;
% kills and cancels alone. The set must be that of the case alone on a store of
% its own, to the last digit. 'shared': all events; the runs of one are samples
% of the other. Which samples there are depends on who was first, on what
% measured.csv asked for meanwhile and on the packing that replaces a forgotten;
% so there the same set is one that is called calibrated, as alone, meets all
% measured values by the formula without scatter, and has no result farther from
% that of the set found alone than its tolerance.
%
% Writes benchmarks/results/twoUsers-PAIR.csv: pair, event, kind, user, second,
% records, lost, touched, repeated (these three must be 0), what was said; and
% twoUsers-PAIR-sets.csv: pair, user, the set alone and after all, largest miss,
% largest difference to alone (in tolerances), same, new runs of a last start.
%
% See also: storeWatch, userCase, faultTrial

1;

function pair = newPair (place, name)
  store = fullfile (place, 'store');
  cellfun (@(d) mkdir (d), {place, store}, 'UniformOutput', false);
  for k = 1:2
    if strcmp (name, 'alone')
      store = fullfile (place, sprintf ('store%d', k));
      [~, ~] = mkdir (store);
    end
    rig = k * ~strcmp (name, 'shared');
    home = fullfile (place, sprintf ('user%d', k));
    users(k) = userCase (home, store, k, rig);
    shareStore (store, users(k));
  end
  pair = struct ('name', name, 'store', store, 'users', users, 'began', ...
                 time (), 'seen', storeWatch (store));
end

function yes = works (user)
  yes = user.pid > 0 && ~isempty (processStart (user.pid));
end

function status = endOf (user)
  status = str2double (readText (fullfile (user.home, 'status')));
end

function users = finished (users, most)
  began = time ();
  while any (arrayfun (@works, users))
    if time () - began > most
      error ('twoUsers: a start has not ended after %g s', most);
    end
    pause (0.2);
  end
end

% What no event of the other one may change.
function s = stateOf (user, seen)
  read = @(name) readText (fullfile (user.folder, name));
  isOut = strcmp ({seen.owner}, caseId (user.folder)) & ...
          strcmp ({seen.status}, 'forgotten');
  % a start that goes on after a kill takes over what the dead one has left
  lock = lockHolder (user.folder);
  s = struct ('works', works (user), ...
              'lock', lock.text(1:end * strcmp (lock.state, 'alive')), ...
              'files', {cellfun(read, {'loadInput.m', 'measured.csv', ...
                                       'decalioc.id'}, ...
                                'UniformOutput', false)}, ...
              'out', {{seen(isOut).folder}});
end

function texts = harmed (user, before, now)
  texts = {};
  % it may have ended by itself
  if before.works && ~now.works && ~any (endOf (user) == [0, 2])
    texts{end + 1} = sprintf ('its start ended with status %d', endOf (user));
  end
  if before.works && now.works && ~isempty (before.lock) && ...
     ~strcmp (before.lock, now.lock)
    texts{end + 1} = 'its lock is another one';
  end
  isThere = ~cellfun (@isempty, before.files);      % the id, from some time on
  if ~isequal (before.files(isThere), now.files(isThere))
    texts{end + 1} = 'a file of it has changed';
  end
  if ~isequal (before.out, now.out)
    texts{end + 1} = 'other runs of it are out of use';
  end
end

% One event, and what the store and the other case are like after it.
function [pair, row] = oneEvent (pair, n, kind)
  k = randi (2);
  isBad = @(user) ~works (user) && ~any (endOf (user) == [0, 2]);
  ended = repmat ({'a start ended with an error'}, 1, ...
                  sum (arrayfun (isBad, pair.users)));
  if any (strcmp (kind, {'kill', 'cancel'})) && ~works (pair.users(k))
    pair.users(k) = asUser (pair.users(k));
  end
  awaitMoment (pair, k);
  other = pair.users(3 - k);
  before = stateOf (other, storeWatch (pair.store));
  [pair.users(k), said] = hitUser (pair.users(k), kind, pair.seen);
  owners = arrayfun (@(u) caseId (u.folder), pair.users, ...
                     'UniformOutput', false);
  [pair.seen, faults] = storeWatch (pair.store, pair.seen, ...
                                    struct ('owner', owners, 'time', ...
                                            {pair.users.hit}));
  faults.touched = [faults.touched, ended, ...
                    harmed(other, before, stateOf (other, pair.seen))];
  texts = [{said}(~isempty (said)), faults.lost, faults.touched, ...
           faults.repeated];
  row = sprintf ('%s,%d,%s,%d,%.0f,%d,%d,%d,%d,%s', pair.name, n, kind, k, ...
                 time () - pair.began, ...
                 sum (~cellfun (@isempty, {pair.seen.status})), ...
                 numel (faults.lost), numel (faults.touched), ...
                 numel (faults.repeated), strjoin (texts, '; '));
  if ~works (pair.users(k))
    pair.users(k) = asUser (pair.users(k));
  end
end

% Until the store has some more records, none at times, and a bit: on a busy
% machine the moments of a start are not told by the clock.
function awaitMoment (pair, k)
  count = @() numel (glob (fullfile (pair.store, 'optim', '*', '*', ...
                                     'record.json')));
  wanted = count () + randi ([0, 6]);
  began = time ();
  while works (pair.users(k)) && time () - began < 60 && count () < wanted
    pause (0.5);
  end
  pause (rand () * 3);
end

% Both to their ends, then once more; NNEW 1 x 2, runs that this made.
function [pair, nNew] = toTheEnd (pair)
  for k = 1:2
    pair.users(k) = hitUser (pair.users(k), 'back', pair.seen);
  end
  for round = 1:2
    waitFor (pair.users);
    before = storeWatch (pair.store);
    pair.users = arrayfun (@asUser, pair.users);
    waitFor (pair.users);
    now = storeWatch (pair.store);
  end
  made = @(user) sum (strcmp ({now.owner}, caseId (user.folder))) - ...
                 sum (strcmp ({before.owner}, caseId (user.folder)));
  nNew = arrayfun (made, pair.users);
end

function waitFor (users)
  began = time ();
  while any (arrayfun (@works, users))
    if time () - began > 1800
      error ('DEcalioc:twoUsers:runFailed', ...
             'twoUsers: a start must end within half an hour.');
    end
    pause (0.2);
  end
end

% Of the set in results/calibration.json, the results in tolerances (1 %).
function [P, Z, isGood] = setOf (user)
  c = readJsonFile (fullfile (user.folder, 'results', 'calibration.json'));
  P = [NaN, NaN];
  if ~isempty (c)
    P = [c.params.a, c.params.b];
  end
  results = @(p) [p(1) + p(2), p(1) * p(2), p(1) * (1:3) + p(2), p(1) - p(2)];
  Z = results (P) ./ results (user.truth) / 0.01;
  isGood = endOf (user) == 0 && isequal (jsonAt (c, {'converged'}), true) && ...
           all (abs (Z - 100) <= 1);
end

function row = setRow (pair, alone, k, nNew)
  [P, Z, isGood] = setOf (pair.users(k));
  [P0, Z0, wasGood] = setOf (alone.users(k));
  isEqual = max (abs (Z - Z0)) <= strcmp (pair.name, 'shared');
  isSame = isGood && wasGood && isEqual;
  row = sprintf ('%s,%d,%.15g,%.15g,%.15g,%.15g,%.3f,%.3f,%d,%d', ...
                 pair.name, k, P0, P, max (abs (Z - 100)), ...
                 max (abs (Z - Z0)), isSame, nNew);
end

function kinds = drawKinds (name, n)
  kinds = {'kill', 'kill', 'cancel', 'forget', 'change'};
  kinds = kinds(1:3 + 2 * strcmp (name, 'shared'));
  kinds = kinds(mod (0:n - 1, numel (kinds)) + 1);
  kinds = kinds(randperm (n));
end

function [pair, lines] = manyEvents (pair, n, minutes)
  lines = {};
  kinds = drawKinds (pair.name, n);
  for i = 1:n
    if time () - pair.began > 60 * minutes
      break
    end
    [pair, lines{end + 1}] = oneEvent (pair, i, kinds{i});
    printf ('%s\n', lines{end});
    fflush (stdout);
  end
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
words = [argv()', {'60', '1', 'apart shared', 'Inf'}(numel (argv ()) + 1:end)];
numbers = str2double (words);
rand ('twister', numbers(2));
place = tempname ();
mkdir (place);
alone = newPair (fullfile (place, 'alone'), 'alone');
alone.users = arrayfun (@asUser, alone.users);
for name = strsplit (words{3}, ' ')
  pair = newPair (fullfile (place, name{1}), name{1});
  pair.users = arrayfun (@asUser, pair.users);
  n = round (numbers(1) * [0.25, 0.75] * strcmp (name{1}, {'apart'; 'shared'}));
  [pair, events] = manyEvents (pair, n, numbers(4));
  [pair, nNew] = toTheEnd (pair);
  waitFor (alone.users);
  sets = arrayfun (@(k) setRow (pair, alone, k, nNew(k)), 1:2, ...
                   'UniformOutput', false);
  printf ('%s\n', sets{:});
  call = sprintf ('octave-cli benchmarks/twoUsers.m %s', strjoin (words, ' '));
  columns = 'pair,event,kind,user,second,records,lost,touched,repeated,said';
  resultTable (['twoUsers-', name{1}, '.csv'], call, columns, events);
  columns = 'pair,user,alone_a,alone_b,end_a,end_b,miss,difference,same,new';
  resultTable (['twoUsers-', name{1}, '-sets.csv'], call, columns, sets);
end
