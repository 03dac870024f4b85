% ADDRUNS  Makes runs and adds them to the data: the one door for all runs.
%
% CALL: STATE = addRuns (STATE, PROBLEM, P, E, STAGE [, REPLICATE])
%
%   STATE      struct: data (newData), evaluate and budget (newEvaluate)
%   PROBLEM    see newProblem; limits, allowed and fine are read
%   P          n x d, sets; what is not allowed is not run, see toAllowed
%   E          n x v, values of the level and effect variables; []: PROBLEM.fine
%   STAGE      what they are for (text), see newData
%   REPLICATE  n x 1 (default: see replicateNumbers)
%
% A set of which a run was not made leaves no trace in the data. The others have
% there the numbers that were run (toDigits).

function state = addRuns (state, problem, P, E, stage, replicate)
  if rows (E) < rows (P)
    E = repmat (problem.fine, rows (P), 1);
  end
  P = toDigits (toAllowed (P, problem));
  E = toDigits (E);
  if nargin < 6
    replicate = replicateNumbers (state.data, P, problem.limits);
  end
  [Z, state.budget] = state.evaluate (P, E, replicate, stage, state.budget);
  isTried = ~any (isna (Z), 2);
  state.data = addRows (state.data, P(isTried, :), Z(isTried, :), ...
                        replicate(isTried), stage, E(isTried, :));
end

%!test
%! state.data = newData (1, 1, 1);
%! [state.evaluate, state.budget] = newEvaluate ( ...
%!   @(P, E, r) merge (r > 2, NA, P + E));
%! problem = struct ('limits', [0; 9], 'fine', 0);
%! state = addRuns (state, problem, [1; 1; 1; 2], [0; 5; 0; 0], 'plan');
%! assert ([state.data.X, state.data.E, state.data.Z, ...
%!          state.data.replicate], [1, 0, 1, 1; 1, 5, 6, 2; 2, 0, 2, 1]);
%! assert (state.budget.isUsedUp);
%! state = addRuns (state, problem, 3, [], 'plan');
%! assert (state.data.E(end), 0);
