% LASTLEVEL  The rows of a table that were run at the level that counts.
%
% CALL: DATA = lastLevel (DATA, PROBLEM)
%
%   DATA     see newData; all of it where PROBLEM.coarse has no levels
%   PROBLEM  see newProblem

function data = lastLevel (data, problem)
  if ~isempty (problem.coarse)
    data = keepRows (data, all (data.E == problem.coarse.levels(end, :), 2));
  end
end

%!test
%! problem.coarse = [];
%! data = addRows (newData (1, 1, 1), [1; 2], [3; 4], [1; 1], 'plan', [2; 1]);
%! assert (lastLevel (data, problem), data);
%! problem.coarse.levels = [2; 1];
%! kept = lastLevel (data, problem);
%! assert ({kept.X, kept.E, kept.Z, kept.stage}, {2, 1, 4, {'plan'}});
