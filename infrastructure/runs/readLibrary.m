% READLIBRARY  Table of all runs of a model that a store holds, by its index.
%
% CALL: KINDS = readLibrary (STORE, MODEL)
%       KINDS = readLibrary (STORE, MODEL, H, AGAIN)
%
%   STORE  folder that holds optim/ (text);  MODEL  its name (text)
%   H      element of hashModels: records of versions until 0.9.0 do not say
%          what their key is made of; those whose key proves that they belong to
%          H are taken in, the others are a kind with the input ''. It may hold
%          its input alone, '' where no case is at hand
%   AGAIN  numbers of runs whose records have changed (default: none)
%   KINDS  1 x K struct array of runs with the same variables: input (see
%          hashModels), funs (hash of the evaluation), origin (case folder),
%          names (text, v variables that count, runSeed among them),
%          runs n x (6 + v + m): number of the run folder, state (1 ok, 2
%          invalid, 3 failed by itself, 0 of no use, -1 forgotten), first 7
%          digits of the key, core-seconds, seed, replicate, values, results
%
% The index, optim/MODEL/library.index, is made of the records and holds nothing
% else: what it lacks is read, and where it is missing or torn it is made anew.
% Two that write it at once lose nothing: the next reader finds what is missing.
% Who uses a run looks into its record (libraryRuns).

function kinds = readLibrary (store, model, h, again)
  if nargin < 4
    again = [];
  end
  place = fullfile (store, 'optim', model);
  file = fullfile (place, 'library.index');
  numbers = str2double (listRunFolders (store, model));
  numbers = numbers(isfinite (numbers));
  kinds = loadIndex (file);
  isChanged = false;
  for k = 1:numel (kinds)
    stays = ismember (kinds(k).runs(:, 1), numbers) & ...
            ~ismember (kinds(k).runs(:, 1), again);
    isChanged = isChanged || ~all (stays);
    kinds(k).runs = kinds(k).runs(stays, :);
  end
  isOpen = strncmp ({kinds.origin}, '?', 1) & ...
           ~strcmp ({kinds.origin}, ['?', h.input]);
  kinds(cellfun (@isempty, {kinds.runs}) | isOpen) = [];
  known = cellfun (@(r) r(:, 1), {kinds.runs}, 'UniformOutput', false);
  new = setdiff (numbers, vertcat (zeros (0, 1), known{:}));
  found = cell (1, numel (new));
  for i = 1:numel (new)
    folder = sprintf ('%s/%04d', place, new(i));   % fullfile is slow
    found{i} = lineOf (folder, new(i), h);
  end
  found = [found{:}];
  if ~isempty (found) || isChanged
    kinds = withLines (kinds, found);
    saveIndex (file, kinds);
  end
end

function kinds = loadIndex (file)
  kinds = struct ('input', {}, 'funs', {}, 'origin', {}, 'names', {}, ...
                  'runs', {});
  if ~isfile (file)
    return
  end
  try
    index = load (file);
    if isequal (fieldnames (index.kinds), fieldnames (kinds))
      kinds = index.kinds;
    end
  catch
    % torn: made anew of the records
  end
end

% No fault where the store can be read alone: the next start reads the records.
function saveIndex (file, kinds)
  draft = sprintf ('%s.%d', file, getpid ());
  if saveWhole ('-binary', draft, struct ('kinds', kinds))
    [~, ~] = rename (draft, file);
  end
  [~, ~] = unlink (draft);
end

% [] where there is no record yet.
function line = lineOf (folder, number, h)
  line = [];
  r = readRecord ([folder, '/record.json']);
  if isempty (r) || ~isfield (r, 'key')
    return
  end
  % to be tried again with another rig
  [input, text, origin] = deal ('', '', ['?', h.input]);
  if isfield (r, 'variables')
    [input, text, origin] = deal (r.input, r.variables, r.origin);
  elseif isfield (h, 'defaults')
    text = provenVariables (r, folder, h);
    if ~isempty (text)
      [input, origin] = deal (h.input, '');
    end
  end
  names = strjoin (regexp (text, '\w+(?==)', 'match'), ' ');
  values = sscanf (regexprep (text, '\|\w+=', ' '), '%f')';
  states = struct ('ok', 1, 'invalid', 2, 'failed', 3, 'forgotten', -1);
  state = 0;
  if isfield (states, r.status) && ~any (strcmp (r.cause, {'killed', 'budget'}))
    state = states.(r.status);
  end
  cpu = str2double (checkReadText ([folder, '/cpu']));
  head = sscanf (r.key(1:7), '%x');
  line = struct ('input', input, 'funs', r.funs, 'origin', origin, ...
                 'names', names, 'runs', ...
                 [number, state, head, r.seconds * max(cpu, 1), r.seed, ...
                  r.replicate, values, r.results]);
end

% Of a record that does not say it: its data.head ends in all its variables, in
% the order of runVariables. Effects that were off are not in the key.
function text = provenVariables (r, folder, h)
  text = '';
  head = checkReadText (fullfile (folder, 'data.head'));
  found = regexp (head, '^variable (\w+) equal (\S+)$', 'tokens', ...
                  'lineanchors', 'dotexceptnewline');
  found = vertcat (cell (0, 2), found{:});
  last = find (strcmp (found(:, 1), 'runSeed'), 1, 'last');
  found = found(1:last, :);
  for first = 1:rows (found)
    variables = struct ();
    for pair = found(first:end, :)'
      variables.(pair{1}) = str2double (pair{2});
    end
    for off = {{}, fieldnames(variables)'}
      [key, older, words] = runKey (variables, off{1}, h);
      if any (strcmp (r.key, [{key}, older]))
        text = words;
        return
      end
    end
  end
end

function kinds = withLines (kinds, found)
  every = [kinds, found];
  marks = arrayfun (@markOf, every, 'UniformOutput', false);
  [~, first, group] = unique (marks, 'first');
  [first, order] = sort (first);
  kinds = every(first);
  for k = 1:numel (kinds)
    kinds(k).runs = vertcat (every(group == order(k)).runs);
  end
end

function text = markOf (kind)
  text = sprintf ('%s|%s|%s|%s|%d', kind.input, kind.funs, kind.origin, ...
                  kind.names, columns (kind.runs));
end

%!shared Case, h
%! Case = newCase (standInCase (tempname ()));
%! h = hashModels (Case)(1);
%!test
%! evaluateDEM ([1, 2; 3, 4], Case);
%! file = fullfile (Case.store, 'optim', 'First', 'library.index');
%! kinds = readLibrary (Case.store, 'First', h);
%! assert ({kinds.input, kinds.names, kinds.origin}, ...
%!         {h.input, 'a b runSeed', Case.folder});
%! assert (sortrows (kinds.runs(:, [7, 8, 10, 11])), [1, 2, 3, 2; 3, 4, 7, 12]);
%! % torn, lost, older than a run, of a folder that is gone
%! writeAtomic (file, 'torn');
%! assert (readLibrary (Case.store, 'First', h), kinds);
%! evaluateDEM ([5, 6], Case);
%! more = readLibrary (Case.store, 'First', h);
%! assert (rows (more.runs), 3);
%! assert (readLibrary (Case.store, 'First', h), more);
%! rmdir (fullfile (Case.store, 'optim', 'First', '0003'), 's');
%! assert (rows (readLibrary (Case.store, 'First', h).runs), 2);
%!test
%! % a record of 0.9.0 that its key proves, one of another model
%! record = fullfile (Case.store, 'optim', 'First', '0001', 'record.json');
%! file = fullfile (Case.store, 'optim', 'First', 'library.index');
%! old = rmfield (readRecord (record), {'input', 'variables', 'origin'});
%! writeRecord (record, old);
%! unlink (file);
%! kinds = readLibrary (Case.store, 'First', h);
%! assert ({kinds.names}, {'a b runSeed', 'a b runSeed'});
%! assert ({kinds.origin}, {'', Case.folder});
%! old.key(1) = merge (old.key(1) == 'a', 'b', 'a');
%! writeRecord (record, old);
%! kinds = readLibrary (Case.store, 'First', h, 1);
%! assert (sort ({kinds.input}), {'', h.input});
