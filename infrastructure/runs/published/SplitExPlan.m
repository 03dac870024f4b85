% SPLITEXPLAN  Splits a plan into one stack of rows for each process.
%
% CALL: [MAIN, REST] = SplitExPlan (EXPLAN, NPROC, RUNSPERCPU, REMAINDER)
%
%   EXPLAN      n x d plan
%   NPROC, RUNSPERCPU, REMAINDER  see SplitToCPU
%   MAIN        1 x NPROC cell of RUNSPERCPU x (d + 1): rows of the plan with
%               their number appended as a column
%   REST        1 x REMAINDER cell of 1 x (d + 1)
%
% See also: SplitToCPU, Start

function [main, rest] = SplitExPlan (ExPlan, nProc, runsPerCPU, remainder)
  numbered = [ExPlan, (1:rows (ExPlan))'];
  inMain = nProc * runsPerCPU;
  d = columns (numbered);
  main = mat2cell (numbered(1:inMain, :), repmat (runsPerCPU, 1, nProc), d)';
  rest = num2cell (numbered(inMain + (1:remainder), :), 2)';
end

%!test
%! [main, rest] = SplitExPlan ((1:8)' / 10, 3, 2, 2);
%! assert (main, {[0.1, 1; 0.2, 2], [0.3, 3; 0.4, 4], [0.5, 5; 0.6, 6]});
%! assert (rest, {[0.7, 7], [0.8, 8]});
%! [main, rest] = SplitExPlan ([1; 2], 2, 1, 0);
%! assert (size (main), [1, 2]);
%! assert (isempty (rest));

% SPDX-License-Identifier: GPL-3.0-only
