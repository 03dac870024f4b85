% WITHOUTUNVARIED  Takes parameters that no run has varied out of a case.
%
% CALL: CASE = withoutUnvaried (CASE)
%
%   CASE  see newCase; of one whose runs are all in runs.csv, and to which no run can
%         be added, names, limits and what goes with them lose such parameters, and
%         fixed is 1 x k struct: name; at (1 x (1 + d), constant and factors of the
%         other parameters that give its value); text, what is to be said of it.
%         modelVars has the value of those that are the same in all rows
%
% Of a parameter that is the same in all rows with a result, or that follows from others, by
% a constant and factors, to a thousandth of its range, the rows tell nothing by
% itself: no value, no interval and no share of it would be more than the prior of a
% surrogate. The first is kept; to tell takes three sets more than there are others. One
% that rises or falls with another one in every row, along a line that is bent, is kept,
% too, and said.

function Case = withoutUnvaried (Case)
  Case.fixed = struct ('name', {}, 'at', {}, 'text', {});
  [X, notes] = setsOfTable (Case);
  if rows (X) == 1
    Case.notes{end + 1} = 'no parameter was varied: all rows of runs.csv are of one set';
  end
  if rows (X) < 2
    return
  end
  d = columns (X);
  keep = zeros (1, 0);
  found = Case.fixed;
  for j = 1:d
    [of, c] = followsFrom (X, j, keep, diff (Case.limits(1:2, j)));
    if isempty (c)
      keep(end + 1) = j;
    else
      found(end + 1) = struct ('name', Case.names{j}, 'at', {{of, c}}, 'text', '');
    end
  end
  if isempty (keep)
    return
  end
  notes = [notes, togetherNotes(X(:, keep), Case.names(keep))];
  if ~isempty (found)
    Case = reduced (Case, keep, found);
  end
  Case.notes = [Case.notes, notes];
end

% Numbers of the parameters (zeros (1, 0): none) and C, the constant and the factors, that
% give column J in all rows; C is [] where it varies by itself. Those that are next to
% nothing are of no account. Over half a percent of the WIDTH of its limits it was not varied.
function [of, c] = followsFrom (X, j, keep, width)
  x = X(:, j);
  [of, c] = deal (zeros (1, 0), []);
  range = max (x) - min (x);
  if range <= max (1e-4 * max (abs (x)), 5e-3 * width)
    c = median (x);
  elseif ~isempty (keep) && rows (X) > numel (keep) + 2
    K = X(:, keep);
    factors = pinv (K - mean (K, 1)) * (x - mean (x));
    off = x - mean (x) - (K - mean (K, 1)) * factors;
    if max (abs (off)) < 0.001 * range
      counts = abs (factors') .* (max (K, [], 1) - min (K, [], 1)) > 0.01 * range;
      of = keep(counts);
      c = [mean(x) - mean(K(:, counts), 1) * factors(counts), factors(counts)'];
    end
  end
end

% Pairs of columns of which one rises or falls with the other in all rows, six at least: by
% chance that happens in one of 360 tables, or less.
function notes = togetherNotes (X, names)
  notes = cell (1, 0);
  [~, ~, rank_] = arrayfun (@(j) unique (X(:, j)), 1:columns (X), 'UniformOutput', false);
  for j = 2:columns (X)
    for i = 1:j - 1
      [a, b] = deal (rank_{i}(:), rank_{j}(:));
      if max (a) > 5 && (isequal (a, b) || isequal (a, max (b) + 1 - b))
        notes{end + 1} = sprintf (['%s was varied only together with %s: what is said of ' ...
                                   'one holds for both'], names{[j, i]});
      end
    end
  end
end

% What the table of a case holds that can make no run, and notes on it; 0 x d else.
function [X, notes] = setsOfTable (Case)
  X = zeros (0, numel (Case.names));
  notes = cell (1, 0);
  file = fullfile (Case.folder, 'runs.csv');
  isAlone = Case.options.maxNewRuns == 0 && ...
            ~any (isfolder (fullfile (Case.store, 'optim', {Case.models.name})));
  if ~isfile (file) || Case.isCost || ...
     ~(isAlone || any (cellfun (@isempty, {Case.models.folder})))
    return
  end
  try
    table = importRuns (file, Case);
    X = unique (table.X(any (isfinite (table.Z), 2), :), 'rows');
    notes = heldInModel (table, Case);
  catch
    return                                     % who takes the runs in says why
  end
end

% Of several models one may not have a parameter, or was run at one value of it.
function notes = heldInModel (table, Case)
  notes = cell (1, 0);
  width = diff (Case.limits(1:2, :));
  isVaried = @(X) max (X, [], 1) - min (X, [], 1) > 5e-3 * width;
  for k = 1:numel (Case.models)
    X = table.X(any (isfinite (table.Z(:, [Case.targets.model] == k)), 2), :);
    for j = find (rows (X) > 2 & isVaried (table.X) & ~isVaried (X))
      notes{end + 1} = sprintf (['%s is %.4g in all rows of %s: what it does there is not ' ...
                                 'known. If %s does not have it, leave these cells empty'], ...
                                Case.names{j}, X(1, j), Case.models(k).name, ...
                                Case.models(k).name);
    end
  end
end

function Case = reduced (Case, keep, found)
  names = Case.names;
  for f = found
    [of, c] = f.at{:};
    partners = names(of);
    f.at = [c(1), zeros(size (keep))];
    f.at([false, ismember(keep, of)]) = c(2:end);
    if isempty (partners)
      Case.modelVars.(f.name) = c;
      ends = Case.limits(1:2, strcmp (f.name, names));
      f.text = sprintf ('%s was never varied: it is %.6g in all runs', f.name, c);
      if c < ends(1) || c > ends(2)
        f.text = sprintf ('%s, outside its limits (%g to %g)', f.text, ends);
      end
    else
      partners = strjoin (partners, ' and ');
      f.text = sprintf (['%s was varied only together with %s, from which it follows: ' ...
                         'what is said of %s holds for it, too'], f.name, partners, partners);
    end
    Case.fixed(end + 1) = f;
  end
  expand = @(P) expanded (P, numel (names), keep, Case.fixed, names);
  Case.names = names(keep);
  for field = {'limits', 'bySelf', 'paramMean', 'paramSd', 'perCondition'}
    Case.(field{1}) = Case.(field{1})(:, keep);
  end
  if ~isempty (Case.allowed)
    Case.allowed.values = Case.allowed.values(keep);
    Case.allowed.sample = Case.allowed.sample(:, keep);
    Case.allowed.rules = cellfun (@(rule) @(P) rule (expand (P)), Case.allowed.rules, ...
                                  'UniformOutput', false);
  end
  Case.notes = [Case.notes, {Case.fixed.text}];
end

function X = expanded (P, d, keep, fixed, names)
  X = zeros (rows (P), d);
  X(:, keep) = P;
  for f = fixed
    X(:, strcmp (f.name, names)) = f.at(1) + P * f.at(2:end)';
  end
end

%!function Case = newUnread (d, varargin)
%!  % a case of D parameters and of a table alone
%!  raw = standInCase (tempname ());
%!  raw.Input.maxNewRuns = 0;
%!  raw.assign = {'a', 'b', 'c'}(1:d);
%!  raw.paramLims = repmat ([0; 10], 1, d);
%!  for model = {'First', 'Second'}
%!    file = fullfile (raw.folder, 'DEMmodels', model{1}, 'data.head');
%!    writeAtomic (file, [fileread(file), "\nvariable c equal 1\n"]);
%!  end
%!  for k = 1:2:numel (varargin)
%!    raw.Input.(varargin{k}) = varargin{k + 1};
%!  end
%!  putTable (raw.folder, raw.assign, ones (1, d));
%!  Case = newCase (raw);
%!endfunction
%!function putTable (folder, names, X)
%!  text = sprintf ([repmat(',%.4g', 1, columns (X)), ",1,2\n"], X');
%!  writeAtomic (fullfile (folder, 'runs.csv'), ...
%!               [strjoin([{'model'}, names, {'First_1', 'First_2'}], ','), "\n", ...
%!                regexprep(text, '^,', 'First,', 'lineanchors')]);
%!endfunction
%!function Case = of (cases, X)
%!  Case = cases{columns (X)};
%!  putTable (Case.folder, Case.names, X);
%!  Case = withoutUnvaried (Case);
%!endfunction
%!shared a, b, cases
%! a = (1:9)';
%! b = mod (a * 4, 9);
%! cases = {[], newUnread(2), newUnread(3)};
%!test
%! assert (isempty (of (cases, [a, b]).fixed));
%! Case = of (cases, [a, 0.3 + 0 * a, b]);
%! assert (Case.names, {'a', 'c'});
%! assert (Case.fixed.at, [0.3, 0, 0]);
%! assert (Case.modelVars.b, 0.3);
%! assert (of (cases, [a, 0.3 + 0.003 * a, b]).names, {'a', 'c'});   % 0.2 % of its limits
%! assert (size (Case.limits), [2, 2]);
%! assert (! isempty (regexp (Case.notes{end}, 'b was never varied: it is 0.3 .*runs$')));
%! assert (! isempty (strfind (of (cases, [a, 12 + 0 * a, b]).notes{end}, ...
%!                             '12 in all runs, outside its limits (0 to 10)')));
%!test
%! % a parameter that one of two models was never run with
%! Case = cases{2};
%! writeAtomic (fullfile (Case.folder, 'runs.csv'), ...
%!              ["model,a,b,First_1,First_2,Second_1\n", ...
%!               sprintf("First,%g,%g,1,2,\nSecond,%g,7,,,3\n", [a, b, a]')]);
%! said = withoutUnvaried (Case).notes{end};
%! assert (strncmp (said, 'b is 7 in all rows of Second', 28), said);
%!test
%! % a fixed ratio; with a constant beside; rounded
%! Case = of (cases, [a, b, 0.3 * a]);
%! assert (Case.names, {'a', 'b'});
%! assert (Case.fixed.at, [0, 0.3, 0], 1e-9);
%! assert (! isempty (strfind (Case.fixed.text, 'together with a')));
%! assert (of (cases, [a, b, 1 - 0.1 * b]).fixed.at, [1, 0, -0.1], 1e-3);
%! % of two others
%! Case = of (cases, [a, b, 1 + 0.5 * a - b / 9]);
%! assert (Case.fixed.at, [1, 0.5, -1/9], 2e-3);
%! assert (! isempty (strfind (Case.fixed.text, 'together with a and b')));
%! assert (isempty (of (cases, [a, b, b.^2 / 9 - a]).fixed));
%! % so few sets tell nothing of a line
%! assert (isempty (of (cases, [a, b, 0.3 * a](1:3, :)).fixed));
%! assert (of (cases, [a, 2 + 0 * a, b](1:3, :)).names, {'a', 'c'});
%! % along a bent line; next to nothing; where no run has a result
%! Case = of (cases, [a, a.^2 / 9, b]);
%! assert (Case.names, {'a', 'b', 'c'});
%! assert (! isempty (strfind (strjoin (Case.notes), 'b was varied only together with a:')));
%! assert (of (cases, [a, 2 + 1e-5 * a, b]).names, {'a', 'c'});
%!test
%! % conditions see all parameters
%! Case = of ({[], [], newUnread(3, 'constraints', 'a < b')}, [a, 3 + 0 * a, b]);
%! assert (isAllowed ([2, 1; 4, 1], Case), [true; false]);
%! % where runs can be made, they vary what the table has not
%! assert (of ({[], [], newUnread(3, 'maxNewRuns', 5)}, [a, 3 + 0 * a, b]).names, {'a', 'b', 'c'});
%! Case = of (cases, [3 + 0 * a, 4 + 0 * a]);
%! assert (Case.names, {'a', 'b'});
%! assert (! isempty (strfind (Case.notes{end}, 'no parameter was varied')));

% SPDX-License-Identifier: GPL-3.0-only
