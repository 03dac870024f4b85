% NEWBUDGET  What the runs of one start have cost, and how many are left.
%
% CALL: BUDGET = newBudget ()           any number of runs, of one model
%       BUDGET = newBudget (CASE)
%
%   CASE    see newCase; where a model folder is not there, none can be made
%   BUDGET  scalar struct, in runs (one a model and set): left, perSet, new,
%           reused (from the store), failed; coreSeconds; seconds (1 x M cell,
%           of the runs that ended well, see addSeconds); levels (n x (v + 1):
%           levels of a set that was run, its core-seconds); isUsedUp: a run
%           that was wanted was not made
%
% It travels in the state, and evaluate brings it up to date (addRuns).

function budget = newBudget (Case)
  budget = struct ('left', Inf, 'perSet', 1, 'new', 0, 'reused', 0, ...
                   'failed', 0, 'coreSeconds', 0, 'seconds', {{[]}}, ...
                   'levels', [], 'isUsedUp', false);
  if nargin > 0
    budget.perSet = numel (Case.models);
    budget.left = Case.options.maxNewRuns;
    budget.seconds = {Case.models.seconds};
    if any (cellfun (@isempty, {Case.models.folder}))
      budget.left = 0;
      budget.isUsedUp = true;
    end
  end
end

%!test
%! Case.options.maxNewRuns = 16;
%! Case.models = struct ('folder', {'a', 'b'}, 'seconds', []);
%! budget = newBudget (Case);
%! assert ([budget.left, budget.perSet], [16, 2]);
%! Case.models(2).folder = '';
%! assert (newBudget (Case).left, 0);
%! assert (newBudget ().left, Inf);
