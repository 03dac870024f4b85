% UNITINPUTS  Inputs of a surrogate in the unit box: parameters, and one beside.
%
% CALL: U = unitInputs (P, LIMITS, V)
%
%   P       n x d, parameter sets, or n x (d + 1): beside them a further input
%           that needs no box (unitLevel makes it of levels)
%   LIMITS  of the d parameters, see toUnit
%   V       0, or 1 for a surrogate that has a further input
%   U       n x (d + V); what P does not have is 0

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

% SPDX-License-Identifier: GPL-3.0-only
