% START  Carries out the runs of one stack, one after the other.
%
% CALL: RESULTS = Start (MATR, MODEL)
%       [RESULTS, RECORDS] = Start (MATR, MODEL, CASE, JOBS)
%
%   MATR     n x (d + 2): parameters, row number of the plan, model number
%   MODEL    1 x M cell of model names
%   CASE     see newCase (default: the case of the current folder)
%   JOBS     struct array, see newJobs: the job of each row number, with its
%            seed and effects (default: first replicates without effects)
%   RESULTS  m x n, one column a run; NaN where a run failed
%   RECORDS  1 x n struct array, see newRecord
%
% See also: runScript, SplitExPlan

function [results, records] = Start (matr, model, Case, jobs)
  if nargin < 3
    Case = loadCase ();
  end
  columnsOf = cell (1, rows (matr));
  kept = cell (1, rows (matr));
  for i = 1:rows (matr)
    job = {};
    if nargin > 3
      job = {jobs(matr(i, end - 1))};
    end
    [res, kept{i}] = runScript (matr(i, :), model{matr(i, end)}, Case, job{:});
    columnsOf{i} = cell2mat (res(:));
  end
  results = [columnsOf{:}];
  records = [kept{:}];
end

%!test
%! Case = readyCase ();
%! [z, r] = Start ([1, 2, 1, 1; 5, 6, 2, 1], {'First', 'Second'}, Case);
%! assert (z, [3, 11; 2, 30], 1e-12);
%! assert ({r.status}, {'ok', 'ok'});

% SPDX-License-Identifier: GPL-3.0-only
