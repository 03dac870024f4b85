% START  Carries out the runs of one stack, one after the other.
%
% CALL: RESULTS = Start (MATR, MODEL)
%       [RESULTS, RECORDS] = Start (MATR, MODEL, CASE)
%
%   MATR     n x (d + 2): parameters, row number of the plan, model number
%   MODEL    1 x M cell of model names
%   CASE     see newCase (default: the case of the current folder)
%   RESULTS  m x n, one column a run; NaN where a run failed
%   RECORDS  1 x n struct array, see newRecord
%
% See also: runScript, SplitExPlan

function [results, records] = Start (matr, model, Case)
  if nargin < 3
    Case = loadCase (fileparts (fileparts (mfilename ('fullpath'))), pwd ());
  end
  columnsOf = cell (1, rows (matr));
  kept = cell (1, rows (matr));
  for i = 1:rows (matr)
    [res, kept{i}] = runScript (matr(i, :), model{matr(i, end)}, Case);
    columnsOf{i} = cell2mat (res(:));
  end
  results = [columnsOf{:}];
  records = [kept{:}];
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! [z, r] = Start ([1, 2, 1, 1; 5, 6, 2, 1], {'First', 'Second'}, Case);
%! assert (z, [3, 11; 2, 30], 1e-12);
%! assert ({r.status}, {'ok', 'ok'});
