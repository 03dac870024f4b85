% UNITINPUTS  Inputs of a surrogate in the unit box: parameters, and the level.
%
% CALL: U = unitInputs (P, LIMITS, V)
%
%   P       n x d, parameter sets, or n x (d + 1): beside them how coarse the
%           runs are (unitLevel), which needs no box
%   LIMITS  of the d parameters, see toUnit
%   V       0, or 1 for a surrogate that has the level as an input
%   U       n x (d + V); without a level in P it is 0, the one that counts
%
% The one place where a level becomes a column of a Kriging model.

function U = unitInputs (P, limits, v)
  d = columns (limits);
  U = toUnit (P(:, 1:d), limits);
  U(:, d + 1:d + v) = 0;
  given = min (columns (P), d + v);
  U(:, d + 1:given) = P(:, d + 1:given);
end

%!assert (unitInputs ([3, 0.5; 2, 1], [2; 4], 1), [0.5, 0.5; 0, 1])
%!assert (unitInputs ([3; 2], [2; 4], 1), [0.5, 0; 0, 0])
%!assert (unitInputs ([3, 0.5; 2, 1], [2; 4], 0), [0.5; 0])
