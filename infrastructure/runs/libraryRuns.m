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
%         them, and too far away to be of use), origin (1 x c cell of case folders), count (1 x
%         c), passed (1 x p struct model, why, count: runs that another
%         value of a variable shuts out), other (1 x o struct model, number,
%         count: runs of another rig or build, and the newest of them)
%   REST  as DATA: rows in reach that a surrogate cannot hold
%
% Which runs were taken is kept in results/library.csv: later starts of the same
% input take the same ones, so that they find their own runs again. Each is
% read from its record; the index only says where to look. Runs that another
% getResults evaluated are evaluated again, 300 at most.

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
  file = fullfile (Case.folder, 'results', 'library.csv');
  [fixed, mark] = fixedRuns (file, Case, h);
  if isequal (fixed, [0, 0]) && strcmp (Case.store, Case.folder)
    none.run = zeros (0, 2);
    none.origin = {};
    keepList (file, mark, none, Case, isLook);
    return
  end
  again = repmat ({zeros(0, 2)}, 1, numel (Case.models));
  for attempt = 1:3
    [found, tally] = familyRuns (Case, h, again);
    [table, row] = joinModels (found.inputs, found.run(:, 1), ...
                               found.run(:, 3), found.Z, Case);
    found = keepRows (found, row > 0);
    row = row(row > 0);
    [use, table] = chosen (table, row, found.run, problem, fixed);
    taken = keepRows (found, use(row));
    again = changed (taken, Case, h, isLook);
    if isLook || all (cellfun (@isempty, again))
      break
    end
  end
  if ~isLook
    lost = ismember (found.run(:, 1:2), vertcat (again{:}), 'rows');
    use(row(lost)) = false;
    taken = keepRows (found, use(row));
  end
  data = keepRows (table, use);
  [~, reach] = insideLimits (table.X, problem.limits, 0.5);
  [~, isIn] = insideLimits (table.X, problem.limits, 0);
  rest = keepRows (table, reach & ~use);
  tally.used = rows (taken.run);
  tally.outside = [sum(use(row) & ~isIn(row)), sum(~reach(row))];
  [tally.origin, ~, which] = unique (taken.origin);
  tally.count = accumarray (which(:), 1)';
  keepList (file, mark, taken, Case, isLook);
end

function [use, table] = chosen (table, row, run, problem, fixed)
  table.replicate(row) = max (table.replicate(row), run(:, 4));
  table.stage(:) = {'library'};
  if isempty (fixed)
    use = nearRows (table, problem);
  else
    use = false (rows (table.X), 1);
    use(row(ismember (run(:, 1:2), fixed, 'rows'))) = true;
  end
end

% Runs that are to be read again, 1 x M cell of n x 2 (model, number): records
% that say something else than the index, or are evaluated anew here.
function again = changed (taken, Case, h, isLook)
  again = repmat ({zeros(0, 2)}, 1, numel (Case.models));
  for k = 1:numel (again)
    stale = {};
    for i = find (taken.run(:, 1) == k)'
      r = recordOf (taken.run(i, :), Case);
      isSame = ~isempty (r) && strcmp (r.funs, taken.funs{i}) && ...
               agrees (r, taken.run(i, :), taken.Z(i, :), k, Case);
      isStale = isSame && taken.run(i, 5) < 3 && ~strcmp (r.funs, h(k).funs);
      if isStale && ~isLook
        stale{end + 1} = r;
      end
      if ~isSame || isStale
        again{k}(end + 1, :) = taken.run(i, 1:2);
      end
    end
    if ~isempty (stale)
      jobs = [stale{:}];
      collectRuns (jobs, {jobs.folder}, Case);
    end
  end
end

function r = recordOf (run, Case)
  folder = fullfile (Case.store, 'optim', Case.models(run(1)).name, ...
                     sprintf ('%04d', run(2)));
  r = readRecord ([folder, '/record.json']);
  if ~isempty (r)
    r.folder = folder;
  end
end

function yes = agrees (r, run, z, k, Case)
  isOfModel = [Case.targets.model] == k;
  index = [Case.targets(isOfModel).index];
  yes = strcmp (r.status, {'ok', 'invalid', 'failed'}{run(5)}) && ...
        sscanf (r.key(1:7), '%x') == run(6);
  if yes && run(5) == 1 && numel (r.results) >= max (index)
    yes = isequaln (r.results(index), z(isOfModel));
  end
end

function [fixed, mark] = fixedRuns (file, Case, h)
  what = {{h.input}, {h.funs}, Case.names, Case.limits, Case.modelVars, ...
          [Case.targets.value], [Case.targets.sd], [Case.targets.tol], ...
          {Case.targets.role}, Case.options.numOfSam, Case.options.seed, ...
          Case.store, Case.coarse};
  mark = ['# ', hash('sha256', jsonencode (what))];
  fixed = [];
  text = checkReadText (file);
  if strncmp (text, mark, numel (mark))
    pairs = regexp (text, '^(\d+),(\d+),', 'tokens', 'lineanchors');
    fixed = [0, 0];
    if ~isempty (pairs)
      fixed = [fixed; reshape(str2double ([pairs{:}]), 2, [])'];
    end
  elseif isempty (text) && strcmp (Case.store, Case.folder) && ...
         isPlanOf (Case)
    fixed = [0, 0];
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

function keepList (file, mark, taken, Case, isLook)
  if isLook
    return
  end
  [~, ~] = mkdir (fileparts (file));
  cells = [num2cell(taken.run(:, 1:2)), ...
           {Case.models(taken.run(:, 1)).name}', taken.origin]';
  writeAtomic (file, [mark, "\nnumber,run,model,case\n", ...
                      sprintf("%d,%d,%s,%s\n", cells{:})], false);
end

%!function [Case, problem] = another (store)
%!  % the same bench, another folder, other limits
%!  raw = standInCase (tempname ());
%!  raw.Input.store = store;
%!  raw.paramLims = [5, 5; 10, 10];
%!  Case = newCase (raw);
%!  problem = newProblem (Case);
%!endfunction

%!shared store, P
%! P = [1, 2; 3, 4; 5, 6; 9, 9; 9, 9];
%! first = newCase (standInCase (tempname ()));
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
%! % another rig; an index that lies; a getResults that has changed
%! [Case, problem] = another (store);
%! clean = libraryRuns (Case, problem);
%! delete (fullfile (Case.folder, 'results', 'library.csv'));
%! file = fullfile (store, 'optim', 'First', 'library.index');
%! index = load (file);
%! kinds = index.kinds;
%! kinds(1).runs(:, 10) = 99;
%! save ('-binary', file, 'kinds');
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
%! % its own runs: not those of its plan, but after the limits have changed
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
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
