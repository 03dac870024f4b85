% RESIDUALHANDLES  Residuals and Jacobian of a search on the surrogates.
%
% CALL: [F, J] = residualHandles (SURROGATES, PROBLEM, ISWIDE)
%
% ISWIDE  see surrogateJacobian;  F, J  handles of p (1 x d), for one search
%
% A set and its neighbours cost hardly more than the set alone (a call of
% stk_predict is 1 ms), and a search asks for both: they are predicted together,
% and kept as long as the handles.

function [f, J] = residualHandles (surrogates, problem, isWide)
  known = containers.Map ();
  at = @(p) lookedUp (known, p, @() surrogateJacobian (surrogates, problem, ...
                                                       p, isWide));
  f = @(p) at (p).f;
  J = @(p) at (p).J;
end

function found = lookedUp (known, p, compute)
  key = sprintf ('%.17g ', p);
  if ~isKey (known, key)
    [found.J, found.f] = compute ();
    known(key) = found;
  end
  found = known(key);
end

%!test
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (15, 2);
%! s = fitSurrogate (X, 1 + X * [2; 3], [0, 0; 1, 1]);
%! problem = smallProblem (2, 0.5, 2);
%! [f, J] = residualHandles (s, problem, false);
%! assert ({f([0.5, 0.5]), J([0.5, 0.5])}, {1.5, [2, 3]}, 0.03);
%! assert (f ([0.1, 0.5]), 0.7, 0.03);

% SPDX-License-Identifier: GPL-3.0-only
