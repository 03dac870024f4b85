% READLIBRARY  Table of all runs of a model that a store holds, by its index.
%
% CALL: [KINDS, TORN] = readLibrary (PLACE)
%       [KINDS, TORN] = readLibrary (PLACE, AGAIN)
%
%   PLACE  folder of the model's runs, optim/MODEL (text), see runPlace
%   AGAIN  numbers of runs that are read again in any case (default: none)
%   KINDS  1 x K struct array of runs with the same variables: input (see
%          hashModels), funs (digest of the question, see readingOf: a run that
%          answered several is in several kinds), origin (case folder), owner
%          (which case, see caseId; ''), label (of the case, for the user),
%          names (text, v variables that count, runSeed among them),
%          runs n x (6 + v + m): number of the run folder, state (1 ok, 2
%          invalid, 3 failed by itself, 0 of no use, -1 forgotten), first 7
%          digits of the key, core-seconds, seed, replicate, values, results
%   TORN   k x 1, numbers of the runs whose record is torn, or says what no run
%          says (isRunRecord)
%
% The index, optim/MODEL/.index-USER, is made of the records and holds nothing
% else: a record that is not the one it has read (size and time of writing) is
% read again, and where it is missing, torn or not this user's it is made anew.
% Two that write it at once lose nothing: the next reader finds what is missing.
% Who uses a run looks into its record (libraryRuns).

function [kinds, torn] = readLibrary (place, again)
  if nargin < 2
    again = [];
  end
  file = fullfile (place, sprintf ('.index-%d', geteuid ()));
  marks = marksOf (place);
  [kinds, known] = readIndex (file);
  isSame = sameMarks (marks, known) & ~ismember (marks(:, 1), again);
  for k = 1:numel (kinds)
    stays = ismember (kinds(k).runs(:, 1), marks(isSame, 1));
    kinds(k).runs = kinds(k).runs(stays, :);
  end
  if ~all (isSame) || rows (known) ~= rows (marks)
    new = marks(~isSame, 1);
    found = cell (1, numel (new));
    for i = 1:numel (new)
      folder = sprintf ('%s/%04d', place, new(i));   % fullfile is slow
      found{i} = linesOf (folder, new(i));
    end
    kinds = withLines (kinds, [found{:}]);
    writeIndex (file, kinds, marks);
  end
  kinds = reshape (kinds, 1, []);
  labels = caseLabels (kinds);
  for k = 1:numel (kinds)
    kinds(k).label = labels{k};
  end
  torn = setdiff (marks(:, 1), numbersOf (kinds));
end

% Number, size and time of writing of each record, asked of all at once.
function marks = marksOf (place)
  [~, text] = system (['cd ', shellQuote(place), ' 2> /dev/null && ' ...
                       'find . -maxdepth 1 -regex "\./[0-9]+" -printf ' ...
                       '"%f/record.json\0" | LC_ALL=C xargs -0 -r stat -L ' ...
                       '-c "%n %s %.9Y" 2> /dev/null']);
  marks = sscanf (text, '%f/record.json %f %f');
  marks = reshape (marks(1:3 * floor (end / 3)), 3, [])';
  [~, once] = unique (marks(:, 1));
  marks = marks(once, :);
end

function isSame = sameMarks (marks, known)
  [isSame, at] = ismember (marks(:, 1), known(:, 1));
  isSame(isSame) = all (marks(isSame, 2:3) == known(at(isSame), 2:3), 2);
end

function numbers = numbersOf (kinds)
  numbers = cellfun (@(r) r(:, 1), {kinds.runs}, 'UniformOutput', false);
  numbers = vertcat (zeros (0, 1), numbers{:});
end

% A line for each question that the run has answered; [] where there is no
% record yet, or none that is sane and keeps the promise of its key.
function lines = linesOf (folder, number)
  lines = [];
  r = readSane ([folder, '/record.json']);
  if ~isfield (r, 'status')
    return
  end
  names = strtrim (regexprep (r.variables, '\|(\w+)=[^|]*', '$1 '));
  values = sscanf (regexprep (r.variables, '\|\w+=', ' '), '%f')';
  if ~strcmp (r.key, hash ('sha256', [r.input, r.variables])) || ...
     numel (values) ~= sum (r.variables == '=')
    return
  end
  numbers = [sscanf(r.key(1:7), '%x'), r.seconds * cpuOf(folder), r.seed, ...
             r.replicate, values];
  readings = num2cell (givenField (r, 'readings', [])(:)');
  if ~any (strcmp (r.status, {'ok', 'invalid'}))
    readings = {};                      % it counts for no question
  end
  for reading = [{r}, readings]
    lines = [lines, struct('input', r.input, 'funs', ...
                           givenField (reading{1}, 'funs', ''), ...
                           'origin', r.origin, 'owner', ...
                           givenField (r, 'owner', ''), 'names', names, ...
                           'runs', [number, stateOf(reading{1}), numbers, ...
                                    reading{1}.results])];
  end
end

function n = cpuOf (folder)
  n = [];
  fid = fopen ([folder, '/cpu'], 'r');
  if fid >= 0
    n = fscanf (fid, '%d', 1);
    fclose (fid);
  end
  n = max ([n, 1]);
end

function state = stateOf (r)
  states = [1, 2, 3, -1];
  state = states(strcmp (r.status, {'ok', 'invalid', 'failed', 'forgotten'}));
  if isempty (state) || any (strcmp (r.cause, {'killed', 'budget'}))
    state = 0;
  end
end

function kinds = withLines (kinds, found)
  every = [kinds(:)', found];
  every(cellfun (@isempty, {every.runs})) = [];
  marks = arrayfun (@markOf, every, 'UniformOutput', false);
  [~, first, group] = unique (marks, 'first');
  [first, order] = sort (first);
  kinds = every(first);
  for k = 1:numel (kinds)
    kinds(k).runs = vertcat (every(group == order(k)).runs);
  end
end

function text = markOf (kind)
  text = sprintf ('%s|%s|%s|%s|%s|%d', kind.input, kind.funs, kind.origin, ...
                  kind.owner, kind.names, columns (kind.runs));
end

%!shared Case, h
%! Case = readyCase ();
%! h = hashModels (Case)(1);
%!test
%! evaluateDEM ([1, 2; 3, 4], Case);
%! file = fullfile (Case.store, 'optim', 'First', ...
%!                  sprintf ('.index-%d', geteuid ()));
%! kinds = readLibrary (runPlace (Case, 'First'));
%! assert ({kinds.input, kinds.names, kinds.origin}, ...
%!         {h.input, 'a b runSeed', Case.folder});
%! assert (sortrows (kinds.runs(:, [7, 8, 10, 11])), [1, 2, 3, 2; 3, 4, 7, 12]);
%! % torn, lost, older than a run, of a folder that is gone
%! writeAtomic (file, 'torn');
%! assert (readLibrary (runPlace (Case, 'First')), kinds);
%! evaluateDEM ([5, 6], Case);
%! more = readLibrary (runPlace (Case, 'First'));
%! assert (rows (more.runs), 3);
%! assert (readLibrary (runPlace (Case, 'First')), more);
%! % a record that has changed since, whoever has changed it
%! changed = fullfile (Case.store, 'optim', 'First', '0003', 'record.json');
%! r = readRecord (changed);
%! writeRecord (changed, setfield (r, 'status', 'forgotten'));
%! assert (readLibrary (runPlace (Case, 'First')).runs(3, 2), -1);
%! writeRecord (changed, r);
%! assert (readLibrary (runPlace (Case, 'First')), more);
%! rmdir (fullfile (Case.store, 'optim', 'First', '0003'), 's');
%! assert (rows (readLibrary (runPlace (Case, 'First')).runs), 2);
%!test
%! % a run that answered two questions; a record that does not keep its promise
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! h = hashModels (Case)(1);
%! evaluateDEM ([1, 2; 3, 4], Case);
%! file = fullfile (Case.store, 'optim', 'First', '0001', 'record.json');
%! r = readRecord (file);
%! keepRecord (setfield (setfield (r, 'funs', 'g'), 'results', 7));
%! kinds = readLibrary (runPlace (Case, 'First'));
%! assert (sort ({kinds.funs}), sort ({'g', h.funs}));
%! assert (numel (kinds(strcmp ({kinds.funs}, 'g')).runs), 10);
%! writeRecord (file, setfield (r, 'variables', strrep (r.variables, '1', '2')));
%! kinds = readLibrary (runPlace (Case, 'First'));
%! assert (rows (vertcat (kinds.runs)), 1);

% SPDX-License-Identifier: GPL-3.0-only
