% BESTKNOWN  The set with the smallest cost, of a case of one cost (isCost).
%
% CALL: B = bestKnown (CASE)
%
%   CASE  see newCase: its runs.csv is read
%   B     scalar struct, ready for JSON: params (of CASE.names), cost (the mean
%         over the runs of that set), runs (how many), name (of the cost), sets
%         (different ones with a cost), failed (rows without one), outside (sets
%         beyond the limits, which do not count), next (1 x n cell of up to nine
%         structs params, cost, runs: those that follow), converged (false), reason,
%         date, version
%
% No interval and no probability: one number a run does not tell what it is made of,
% nor how it scatters.
%
% Errors: DEcalioc:bestKnown:noRuns; those of importRuns

function b = bestKnown (Case)
  data = importRuns (fullfile (Case.folder, 'runs.csv'), Case);
  isKnown = isfinite (data.Z(:, 1));
  [X, ~, of] = unique (data.X(isKnown, :), 'rows');
  z = data.Z(isKnown, 1);
  runs = accumarray (of(:), 1, [rows(X), 1]);
  cost = accumarray (of(:), z, [rows(X), 1]) ./ runs;
  [~, isIn] = insideLimits (X, Case.limits);
  if ~any (isIn)
    error ('DEcalioc:bestKnown:noRuns', ...
           ['%s must hold a cost of at least one set between the limits of ' ...
            'paramLims, got none of %d rows. decalioc import shows how it is ' ...
            'read.'], fullfile (Case.folder, 'runs.csv'), rows (data.X));
  end
  [~, order] = sort (cost);
  order = order(isIn(order));
  as = @(k) struct ('params', cell2struct (num2cell (X(k, :)'), Case.names(:), 1), ...
                    'cost', cost(k), 'runs', runs(k));
  b = as (order(1));
  b.name = Case.targets(1).name;
  b.sets = numel (order);
  b.failed = sum (~isKnown);
  b.outside = sum (~isIn);
  b.next = arrayfun (as, order(2:min (end, 10))', 'UniformOutput', false);
  b.converged = false;
  b.reason = sprintf (['Best set known: smallest %s, %.5g, of %s. How well it ' ...
                       'is known a cost alone does not tell'], b.name, b.cost, ...
                      countText (b.sets, 'set'));
  b.date = strftime ('%Y-%m-%d', localtime (time ()));
  b.version = toolboxVersion (Case.root);
end

%!test
%! % rows of one set are one, a set beyond the limits and a run that failed are none
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'runs.csv'), ...
%!   "a,b,cost\n1,2,0.5\n1,2,0.3\n2,2,0.45\n3,1,\n9,9,0.01\n2,3,0.41\n");
%! Case = struct ('folder', folder, 'names', {{'a', 'b'}}, 'limits', [0, 0; 5, 5], ...
%!                'effectVars', {{}}, 'effects', [], 'coarse', struct ('variable', {}), ...
%!                'models', struct ('name', 'M'), 'further', {{}}, ...
%!                'root', fileparts (fileparts (which ('startToolbox'))));
%! Case.targets = struct ('name', 'cost', 'model', 1, 'unit', '', 'role', 'smallest');
%! b = bestKnown (Case);
%! assert ({b.params.a, b.params.b, b.runs}, {1, 2, 2});
%! assert (b.cost, 0.4, 1e-12);
%! assert ([b.sets, b.failed, b.outside], [3, 1, 1]);
%! assert (cellfun (@(n) n.cost, b.next), [0.41, 0.45]);
%!error id=DEcalioc:bestKnown:noRuns
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'runs.csv'), "a,cost\n1,0.5\n");
%! Case = struct ('folder', folder, 'names', {{'a'}}, 'limits', [2; 5], ...
%!                'effectVars', {{}}, 'effects', [], 'coarse', struct ('variable', {}), ...
%!                'models', struct ('name', 'M'), 'further', {{}});
%! Case.targets = struct ('name', 'cost', 'model', 1, 'unit', '', 'role', 'smallest');
%! bestKnown (Case);

% SPDX-License-Identifier: GPL-3.0-only
