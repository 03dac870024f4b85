% RUNSTABLE  Statement: how many runs of each model ended how.
%
% CALL: T = runsTable (PAGE)
%
%   PAGE  see pageData
%   T     see newTable; no rows where nothing is known of runs

function T = runsTable (page)
  runs = givenField (page, 'runs', struct ('model', {}));
  states = {'ok', 'failed', 'timeout', 'invalid', 'not ended'};
  columns = [{'model'; 'ok'; 'failed'; 'timeout'; 'invalid'; 'not ended'}, ...
             repmat({'', 'count'}, 6, 1); {'median time', 's', 'plain'}];
  columns{1, 3} = '';
  T = newTable (page, 'runs', 'Runs in the store', columns, ...
                eachOf (@(model) rowOf (runs(strcmp ({runs.model}, model)), states), ...
                        unique ({runs.model})));
end

function cells = rowOf (own, states)
  seconds = [own(strcmp ({own.status}, 'ok')).seconds];
  seconds = [seconds(isfinite (seconds)), NaN(1, ~any (isfinite (seconds)))];
  cells = [{own(1).model}, eachOf(@(s) sum (strcmp ({own.status}, s)), states), ...
           {median(seconds)}];
end

%!test
%! page.runs = struct ('model', 'M', 'status', {'ok', 'ok', 'failed'}, 'seconds', {1, 3, NaN});
%! page.sources = [];
%! T = runsTable (page);
%! assert (cellfun (@(c) c.value, T.cells(2:end)), [2, 1, 0, 0, 0, 2]);
%! assert (isempty (runsTable (struct ('sources', [])).cells));

% SPDX-License-Identifier: GPL-3.0-only
