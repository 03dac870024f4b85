% RUNSTABLE  Statement: how many runs of each model ended how.
%
% CALL: T = runsTable (PAGE)
%
%   PAGE  see pageData
%   T     see newTable; [] where nothing is known of runs

function T = runsTable (page)
  T = [];
  runs = givenField (page, 'runs', []);
  if isempty (runs)
    return
  end
  states = {'ok', 'failed', 'timeout', 'invalid', 'not ended'};
  models = unique ({runs.model});
  cells = cell (numel (models), numel (states) + 2);
  for k = 1:numel (models)
    own = runs(strcmp ({runs.model}, models{k}));
    counts = cellfun (@(state) sum (strcmp ({own.status}, state)), states, ...
                      'UniformOutput', false);
    seconds = [own(strcmp ({own.status}, 'ok')).seconds];
    seconds = seconds(isfinite (seconds));
    middle = NaN;
    if ~isempty (seconds)
      middle = median (seconds);
    end
    cells(k, :) = [models(k), counts, {middle}];
  end
  columns = [{'model'}, states, {'median time'}]';
  columns(:, 2:3) = {''};
  columns(2:end, 3) = {'count'};
  columns(end, 2:3) = {'s', 'plain'};
  T = newTable (page, 'runs', 'Runs in the store', columns, cells);
end

%!test
%! page.runs = struct ('model', 'M', 'status', {'ok', 'ok', 'failed'}, 'seconds', {1, 3, NaN});
%! page.sources = [];
%! T = runsTable (page);
%! assert (cellfun (@(c) c.value, T.cells(2:end)), [2, 1, 0, 0, 0, 2]);
%! assert (isempty (runsTable (struct ('sources', []))));
