% IMPORTEXISTING  Takes in runs that exist: of a shared store and of runs.csv.
%
% CALL: [DATA, REST, TALLY] = importExisting (CASE, PROBLEM, SAY)
%       importExisting (CASE, PROBLEM, SAY, true)    only looks, see libraryRuns
%
%   CASE  see newCase;  PROBLEM  see newProblem
%   SAY   function handle that takes one line of text
%   DATA  see newData, E the levels of CASE.coarse; empty where there is
%         nothing. Rows of runs.csv with an effect switched on are left out:
%         they belong to the diagnosis; of more than 1000, those of thinRuns are
%         taken
%   REST  as DATA: the others, which tell what is lost with them
%   TALLY  see libraryRuns

function [data, rest, tally] = importExisting (Case, problem, say, varargin)
  [data, rest] = ofTable (Case, problem, say);
  whole = Case;
  Case = plainCase (Case);               % effects of the diagnosis are off
  [found, tally, left] = libraryRuns (Case, problem, varargin{:});
  data = joined (found, data);
  rest = joined (rest, left);
  if isempty (varargin)
    sayOldRuns (whole, say, tally);
  end
end

function both = joined (first, second)
  both = first;
  for name = fieldnames (first)'
    both.(name{1}) = [first.(name{1}); second.(name{1})];
  end
end

% What is expected beyond all runs says nothing of the material.
function refuseOutside (X, Case, say)
  [~, isIn] = insideLimits (X, Case.limits, 0.5);
  if isempty (X) || any (isIn)
    return
  end
  isOut = find (all (X < Case.limits(1, :) | X > Case.limits(2, :), 1));
  isOut = [isOut, 1:columns(X) * isempty(isOut)];
  parts = arrayfun (@(j) sprintf ('%s has %.4g to %.4g, its limits are %.4g and %.4g', ...
                                  Case.names{j}, min (X(:, j)), max (X(:, j)), ...
                                  Case.limits(:, j)), isOut, 'UniformOutput', false);
  text = sprintf (['some rows of runs.csv must lie between the limits of the case, got ' ...
                   'none of %d (%s). Convert the column to the unit of paramLims, or ' ...
                   'widen paramLims.'], rows (X), strjoin (parts, '; '));
  if Case.options.maxNewRuns > 0
    say (['  WARNING: ', text]);
  else
    error ('DEcalioc:importRuns:badValue', 'importRuns: %s', text);
  end
end

% Results that scatter are not the same at three different sets.
function sayRepeated (data, say)
  isWhole = all (isfinite (data.Z), 2);
  [Z, ~, group] = unique (data.Z(isWhole, :), 'rows');
  [~, ~, set] = unique (data.X(isWhole, :), 'rows');
  for g = 1:rows (Z)
    n = numel (unique (set(group == g)));
    if n > 2 && rows (Z) > 1
      say (sprintf (['  WARNING: the same results (%s) at %d different parameter values: ' ...
                     'where they mark runs that failed or gave nothing, leave the ' ...
                     'fields empty'], strjoin (arrayfun (@(z) sprintf ('%.5g', z), ...
                                                         Z(g, :), 'UniformOutput', ...
                                                         false), ', '), n));
    end
  end
end

function [data, rest] = ofTable (Case, problem, say)
  v = numel (plainCase (Case).effectVars);
  data = newData (numel (Case.names), numel (Case.targets), v);
  rest = data;
  file = fullfile (Case.folder, 'runs.csv');
  if ~isfile (file)
    return
  end
  Case = withEffects (Case);
  [found, ignored] = importRuns (file, Case);
  isOn = found.E ~= neutralEffects (Case);
  isPlain = ~any (isOn(:, v + 1:end), 2);
  say (sprintf ('runs.csv: %s taken in, %d with an effect left aside', ...
                countText (sum (isPlain), 'run'), sum (~isPlain)));
  found = keepRows (found, isPlain);
  refuseOutside (found.X, Case, say);
  sayRepeated (found, say);
  sayLacking (found, problem, say);
  [use, text] = thinRuns (found, problem, 1000);
  found.E = found.E(:, 1:v);
  data = keepRows (found, use);
  rest = keepRows (found, ~use);
  if ~isempty (text)
    say (['  WARNING: ', text]);
  end
  if ~isempty (ignored)
    say (sprintf ('  WARNING: columns that the case does not know: %s', ...
                  strjoin (ignored(:)', ', ')));
  end
end

% Nobody knows why a cell is empty. A run that says that it failed to give a result is an
% outcome (lackingAt).
function sayLacking (found, problem, say)
  isThere = isfinite (found.Z);
  for t = 1:columns (isThere)
    isOf = any (isThere(:, problem.bench == problem.bench(t)), 2);
    lacks = sum (isOf & isna (found.Z(:, t)));
    if lacks > 0 && any (isThere(:, t))
      say (sprintf (['  WARNING: %d of %d rows of runs.csv have other results of their ' ...
                     'model and no %s, which is judged by the other rows alone. Write ' ...
                     'failed where a run gave none, 0 where nothing flowed or moved'], ...
                    lacks, sum (isOf), problem.targetNames{t}));
    end
  end
end

%!test
%! Case = readyCase ();
%! quiet = @(text) [];
%! assert (size (importExisting (Case, newProblem (Case), quiet).X), [0, 2]);
%! writeAtomic (fullfile (Case.folder, 'runs.csv'), ...
%!   ["model,seed,a,b,First_1,First_2,Second_1\n", ...
%!    "First,1,1,2,3,2,\nSecond,1,1,2,,,-1\n"]);
%! data = importExisting (Case, newProblem (Case), quiet);
%! assert (data.X, [1, 2]);
%! assert (data.Z, [3, 2, -1]);
%!test
%! % a table in another unit says nothing; marks of failure are pointed at
%! Case = readyCase ();
%! Case.options.maxNewRuns = 0;
%! put = @(rows_) writeAtomic (fullfile (Case.folder, 'runs.csv'), ...
%!   ["model,a,b,First_1,First_2,Second_1\n", sprintf("%s,%g,%g,%s\n", rows_{:})]);
%! put ({'First', 2000, 2, '1,2,', 'Second', 2000, 2, ',,3'});
%! fail ('importExisting (Case, newProblem (Case), @disp)', ...
%!       'got none of 1 .a has 2000 to 2000, its limits are');
%! put ({'First', 1, 2, '0,0,', 'First', 2, 3, '0,0,', 'First', 3, 1, '0,0,', ...
%!       'First', 2, 1, '4,5,', 'Second', 1, 2, ',,0', 'Second', 2, 3, ',,0', ...
%!       'Second', 3, 1, ',,0', 'Second', 2, 1, ',,6'});
%! text = evalc ('importExisting (Case, newProblem (Case), @disp);');
%! assert (~isempty (strfind (text, 'the same results (0, 0, 0) at 3 different')), text);
%!test
%! % a store of two cases, and a table beside it
%! first = readyCase ();
%! evaluateDEM ([1, 2; 3, 4], first);
%! raw = standInCase (tempname ());
%! raw.Input.store = first.store;
%! Case = newCase (raw);
%! writeAtomic (fullfile (Case.folder, 'runs.csv'), ...
%!   ["model,seed,a,b,First_1,First_2,Second_1\n", ...
%!    "First,1,7,2,9,14,\nSecond,1,7,2,,,5\n"]);
%! [data, ~, tally] = importExisting (Case, newProblem (Case), @(text) []);
%! assert (data.X, [1, 2; 3, 4; 7, 2]);
%! assert (data.stage, {'library'; 'library'; 'import'});
%! assert (tally.used, 4);
%!test
%! % rows that lack one result of their model and have another one
%! Case = readyCase ();
%! writeAtomic (fullfile (Case.folder, 'runs.csv'), ...
%!   ["model,a,b,First_1,First_2\nFirst,1,2,3,2\nFirst,2,2,4,\nFirst,3,2,5,\n"]);
%! text = evalc ('importExisting (Case, newProblem (Case), @disp);');
%! assert (~isempty (strfind (text, '2 of 3 rows of runs.csv have other results')), text);
%!test
%! % more rows than a surrogate holds: a part is taken, and that is said
%! Case = readyCase ();
%! n = 1500;
%! writeAtomic (fullfile (Case.folder, 'runs.csv'), ...
%!   ["model,a,b,First_1,First_2,Second_1\n", ...
%!    sprintf("First,%d,2,3,2,\n", 1:n), sprintf("Second,%d,2,,,1\n", 1:n)]);
%! text = evalc (['[data, rest] = importExisting (Case, ' ...
%!               'newProblem (Case), @disp);']);
%! assert (rows (data.X), 1000);
%! assert (sortrows ([data.X, data.Z; rest.X, rest.Z]), ...
%!         [(1:n)', repmat([2, 3, 2, 1], n, 1)]);
%! assert (~isempty (strfind (text, '1000 of 1500 runs are used')));

% SPDX-License-Identifier: GPL-3.0-only
