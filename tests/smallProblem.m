% SMALLPROBLEM  The problem of a case of one model, for tests of single steps.
%
% CALL: PROBLEM = smallProblem (VALUE, TOL, D, MORE)
%
%   VALUE    1 x t measured values, each to be fitted;  TOL  their tolerance (share)
%   D        number of parameters (1), a, b ..., each between 0 and 1
%   MORE     scalar struct of further fields of the case (struct ()), see newCase
%   PROBLEM  see newProblem
%
% See also: smallCalibration, smallGapLab

function problem = smallProblem (value, tol, d, more)
  Case = struct ('names', {num2cell('a':'z')}, 'limits', [0; 1], ...
                 'targets', struct ('value', num2cell (value), 'tol', tol));
  if nargin < 3
    d = 1;
  end
  Case.names = Case.names(1:d);
  Case.limits = Case.limits(:, ones (1, d));
  if nargin > 3
    Case = mergeFields (Case, more);
  end
  problem = newProblem (Case);
end

% SPDX-License-Identifier: GPL-3.0-only
