% LIBRARYRUNS  Runs of a shared store that are samples of this case.
%
% CALL: [DATA, TALLY, REST] = libraryRuns (CASE, PROBLEM)
%       [...] = libraryRuns (CASE, PROBLEM, true)   only looks, writes nothing
%
%   CASE  see newCase, without effects;  PROBLEM  see newProblem
%   DATA  see newData, stage 'library': runs of the same model folder, CPUs and
%         LIGGGHTS that differ from those of the case in nothing but design
%         variables, levels and seed; chosen by nearRows. Where Input.store is
%         the case folder these are its own runs, made under other limits,
%         targets, samples or another seed; none as long as nothing of that has
%         changed, for then it finds its runs again
%   TALLY  struct: used (runs), outside (1 x 2, runs outside the limits: near
%         them, and too far away to be of use), origin (1 x c cell of case
%         folders), count (1 x c), passed (1 x p struct model, why, count: runs that another
%         value of a variable shuts out), other (1 x o struct model, number,
%         count: runs of another rig or build, and the newest of them)
%   REST  as DATA: rows in reach that a surrogate cannot hold
%
% Which runs were taken is kept in results/library.csv: later starts of the same
% input take the same ones, so that they find their own runs again. Each is
% read from its record; the index only says where to look. Runs that were not
% asked yet what this case asks (readingOf) are, 300 at most.

function [data, tally, rest] = libraryRuns (Case, problem, isLook)
  data = newData (numel (Case.names), numel (Case.targets), ...
                  numel (Case.effectVars));
  rest = data;
  tally = struct ('used', 0, 'outside', [0, 0], 'origin', {{}}, 'count', []);
  isLook = nargin > 2 && isLook;
  if ~all (cellfun (@isfolder, {Case.models.folder}))
    return
  end
  h = hashModels (Case);
  isAlone = ~sharesStore (Case);
  mark = markOf (Case, h, placeOf (Case));
  [fixed, known] = readTaken (Case.folder);
  % of an earlier toolbox the place of the case was in it
  isFirst = ~any (strcmp (known, {mark, markOf(Case, h, Case.store)})) && ...
            ~(isempty (known) && isAlone && isPlanOf (Case));
  if ~isFirst && isempty (fixed) && isAlone
    none.run = zeros (0, 2);
    none.origin = {};
    keepList (mark, none, Case, isLook);
    return
  end
  kept = repmat ({fixed}, 1, double (~isFirst));
  [fresh, tried] = deal (zeros (0, 2));
  for attempt = 1:6
    [found, tally] = familyRuns (Case, h, fresh);
    [found, table, row] = joined (found, kept, Case);
    [use, table] = chosen (table, row, found.run, problem, kept);
    taken = keepRows (found, use(row));
    % what is taken is as its record says, whatever the index does
    new = setdiff (taken.run(:, 1:2), fresh, 'rows');
    fresh = [fresh; new];
    if isempty (new)
      new = setdiff (taken.run(~taken.isRead & ~isLook, 1:2), tried, 'rows');
      tried = [tried; new];
      readAnew (new, Case);
    end
    if isempty (new)
      break
    end
  end
  found.row = row;
  [use, table] = sound (use, table, found, fresh, isLook);
  taken = keepRows (found, use(row));
  data = keepRows (table, use);
  [~, reach] = insideLimits (table.X, problem.limits, 0.5);
  [~, isIn] = insideLimits (table.X, problem.limits, 0);
  rest = keepRows (table, reach & ~use);
  tally.used = rows (taken.run);
  tally.outside = [sum(use(row) & ~isIn(row)), sum(~reach(row))];
  [tally.origin, ~, which] = unique (taken.origin);
  tally.count = accumarray (which(:), 1)';
  keepList (mark, taken, Case, isLook);
end

% Rows of the runs; a run that was not taken joins none of which one was.
function [found, table, row] = joined (found, kept, Case)
  join = @(f) joinModels (f.inputs, f.run(:, 1), f.run(:, 3), f.Z, Case);
  [table, row] = join (found);
  if ~isempty (kept)
    isTaken = ismember (found.run(:, 1:2), kept{1}, 'rows');
    found = keepRows (found, isTaken | ~ismember (row, row(isTaken)));
    [table, row] = join (found);
  end
  found = keepRows (found, row > 0);
  row = row(row > 0);
end

% Without runs whose record was not read, or gave no answer. For who only looks
% one that will be read anew at the start stands with 0.
function [use, table] = sound (use, table, found, fresh, isLook)
  row = found.row;
  isFresh = ismember (found.run(:, 1:2), fresh, 'rows');
  use(row(~isFresh | (~found.isRead & ~isLook))) = false;
  for i = find (isLook & ~found.isRead & found.run(:, 5) == 1)'
    isOpen = isnan (table.Z(row(i), :)) & ~isna (table.Z(row(i), :));
    table.Z(row(i), isOpen) = 0;
  end
end

% KEPT holds the runs that an earlier start has taken, or nothing.
function [use, table] = chosen (table, row, run, problem, kept)
  table.replicate(row) = max (table.replicate(row), run(:, 4));
  table.stage(:) = {'library'};
  if isempty (kept)
    use = nearRows (table, problem);
  else
    use = false (rows (table.X), 1);
    use(row(ismember (run(:, 1:2), kept{1}, 'rows'))) = true;
  end
end

% What the runs say to the question of this case; it is kept in their records.
function readAnew (runs, Case)
  jobs = [];
  for run = runs'
    folder = runPlace (Case, Case.models(run(1)).name, ...
                       sprintf ('%04d', run(2)));
    record = readRun (folder);
    if ~isempty (record)
      jobs = [jobs, newRecord(record, folder)];
    end
  end
  if ~isempty (jobs)
    collectRuns (jobs, {jobs.folder}, Case);
  end
end

% The input that the list of runs holds for; PLACE of a store with several cases.
function mark = markOf (Case, h, place)
  what = {{h.input}, {h.funs}, Case.names, Case.limits, Case.modelVars, ...
          [Case.targets.value], [Case.targets.sd], [Case.targets.tol], ...
          {Case.targets.role}, Case.options.numOfSam, Case.options.seed, ...
          place, Case.coarse};
  mark = ['# ', hash('sha256', jsonencode (what))];
end

% A store within the case folder moves with it, and a copy has its own.
function place = placeOf (Case)
  place = Case.store;
  if strncmp (place, fullfile (Case.folder, filesep), numel (Case.folder) + 1)
    place = place(numel (Case.folder) + 1:end);
  elseif ~sharesStore (Case)
    place = '';
  end
end

% Of a case that has kept no list: no plan was drawn yet, or one of its limits
% and samples (failed rows are not in the file).
function yes = isPlanOf (Case)
  file = fullfile (Case.folder, 'ExperimentalPlan_DoE.csv');
  [d, n] = deal (numel (Case.names), Case.options.numOfSam);
  yes = ~isfile (file);
  if ~yes
    P = csvread (file);
    P = P(:, 1:min (d, end));
    yes = columns (P) == d && rows (P) >= n / 2 && rows (P) <= n;
  end
  if yes && isfile (file)
    [~, isIn] = insideLimits (P, Case.limits, 0);
    U = toUnit (P, Case.limits);
    yes = all (isIn) && all (max (U, [], 1) - min (U, [], 1) >= 1 - 6 / n);
  end
end

function keepList (mark, taken, Case, isLook)
  if isLook
    return
  end
  file = fullfile (Case.folder, 'results', 'library.csv');
  [~, ~] = mkdir (fileparts (file));
  cells = [num2cell(taken.run(:, 1:2)), ...
           {Case.models(taken.run(:, 1)).name}', taken.origin]';
  writeAtomic (file, [mark, "\nnumber,run,model,case\n", ...
                      sprintf("%d,%d,%s,%s\n", cells{:})], false);
end

%!function [Case, problem] = another (store)
%!  % the same bench, another folder, other limits
%!  Case = readyCase ();
%!  [Case.store, Case.limits] = deal (store, [5, 5; 10, 10]);
%!  problem = newProblem (Case);
%!endfunction

%!shared store, P
%! P = [1, 2; 3, 4; 5, 6; 9, 9; 9, 9];
%! first = readyCase ();
%! evaluateDEM (P, first, [1; 1; 1; 1; 2]);
%! store = first.store;

%!test
%! % those in the box or near it; the second packing of a set is another row
%! [Case, problem] = another (store);
%! [data, tally] = libraryRuns (Case, problem, true);
%! assert (~isfolder (fullfile (Case.folder, 'results')));
%! assert (sortrows ([data.X, data.Z, data.replicate]), ...
%!         [3, 4, 7, 12, -1, 1; 5, 6, 11, 30, -1, 1; ...
%!          9, 9, 18, 81, 0, 1; 9, 9, 18, 81, 0, 2], 1e-12);
%! assert ({tally.used, tally.count, tally.origin}, {8, 8, {store}});
%! assert (unique (data.stage), {'library'});
%! % the next start takes the same ones, though there are more by then
%! again = libraryRuns (Case, problem);
%! assert (again, data);
%! evaluateDEM ([8, 8], Case);
%! assert (libraryRuns (Case, problem), data);
%! problem.limits(1, :) = 0;
%! Case.limits(1, :) = 0;
%! assert (rows (libraryRuns (Case, problem).X), 6);

%!test
%! % nor is a run of another model of a set of the list that comes later
%! [Case, problem] = another (store);
%! file = fullfile (store, 'optim', 'Second', '0002', 'record.json');
%! r = readRecord (file);
%! writeRecord (file, setfield (r, 'status', 'forgotten'));
%! [data, tally] = libraryRuns (Case, problem);
%! writeRecord (file, r);
%! [again, now] = libraryRuns (Case, problem);
%! assert ({now.used, again}, {tally.used, data});

%!test
%! % another rig; an index that lies; a getResults that has changed
%! [Case, problem] = another (store);
%! clean = libraryRuns (Case, problem);
%! delete (fullfile (Case.folder, 'results', 'library.csv'));
%! file = fullfile (store, 'optim', 'First', sprintf ('.index-%d', geteuid ()));
%! [kinds, marks] = readIndex (file);
%! kinds(1).runs(:, [5, 6, 10]) = 99;
%! writeIndex (file, kinds, marks);
%! sorted = @(data) sortrows ([data.X, data.Z, data.replicate]);
%! assert (sorted (libraryRuns (Case, problem)), sorted (clean));
%! funs = fullfile (Case.models(1).folder, 'OctaveFuns', 'getResults.m');
%! writeAtomic (funs, strrep (fileread (funs), '(load (file)'')', ...
%!                            '(100 * load (file)'')'));
%! data = libraryRuns (Case, problem);
%! clean.Z(:, 1:2) = 100 * clean.Z(:, 1:2);
%! assert (sorted (data), sorted (clean), 1e-9);
%! head = fullfile (Case.models(2).folder, 'data.head');
%! writeAtomic (head, [fileread(head), "\n"]);
%! [data, tally] = libraryRuns (Case, problem);
%! assert (all (isna (data.Z(:, 3))));
%! assert ([tally.other.model], 2);
%!test
%! % the first case of an empty store, started again: it has taken none, and
%! % takes none, though there are runs of its own by then
%! [Case, problem] = another (tempname ());
%! libraryRuns (Case, problem);
%! evaluateDEM (P, Case);
%! [data, tally] = libraryRuns (Case, problem);
%! assert ({rows(data.X), tally.used, tally.count}, {0, 0, zeros(1, 0)});
%! delete (fullfile (Case.folder, 'results', 'library.csv'));
%! assert (rows (libraryRuns (Case, problem).X), 3);
%!test
%! % its own runs: not those of its plan, but after the limits have changed
%! Case = readyCase ();
%! quiet = @() libraryRuns (Case, newProblem (Case));
%! assert (isempty (quiet ().X));
%! evaluateDEM (P(1:3, :), Case);
%! assert (isempty (quiet ().X));
%! Case.limits = [2, 2; 5, 5];
%! [data, tally] = libraryRuns (Case, newProblem (Case));
%! assert (sortrows (data.X), [1, 2; 3, 4; 5, 6]);
%! assert ({tally.used, tally.outside}, {6, [4, 0]});
%! Case.limits = [2.9, 3.9; 3.1, 4.1];
%! [data, tally] = libraryRuns (Case, newProblem (Case));
%! assert ({data.X, tally.used, tally.outside}, {[3, 4], 2, [0, 4]});
%! evaluateDEM ([3, 4.05], Case);
%! assert (libraryRuns (Case, newProblem (Case)), data);
%! % nor is it another input where the folder is moved
%! place = [Case.folder, '_moved'];
%! [~, ~] = rename (Case.folder, place);
%! [Case.folder, Case.store] = deal (place);
%! folders = strcat (place, {'/DEMmodels/First', '/DEMmodels/Second'});
%! isIn = all (cellfun (@isfolder, folders));
%! if isIn
%!   [Case.models.folder] = deal (folders{:});
%! end
%! assert (libraryRuns (Case, newProblem (Case)), data);
%!test
%! % a store in the folder of the case, which is copied: no run of it is a sample then
%! Case = readyCase ();
%! Case.store = fullfile (Case.folder, 'store');
%! assert (isempty (libraryRuns (Case, newProblem (Case)).X));
%! evaluateDEM (P(1:3, :), Case);
%! place = [Case.folder, '_copy'];
%! system (['cp -r ', Case.folder, ' ', place]);
%! [Case.folder, Case.store] = deal (place, fullfile (place, 'store'));
%! assert (isempty (libraryRuns (Case, newProblem (Case)).X));

% SPDX-License-Identifier: GPL-3.0-only
