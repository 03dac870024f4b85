% TONORMAL  Maps unknowns to the coordinates in which their prior is N (0, 1).
%
% CALL: U = toNormal (UNKNOWNS, Q)
%
%   UNKNOWNS  struct of viewHypothesis
%   Q         n x d, parameters in [-1, 1], strengths, size
%   U         n x d, cut to [-3, 3]: a start at a limit would never leave it

function U = toNormal (unknowns, Q)
  share = (Q - unknowns.lo) ./ (unknowns.hi - unknowns.lo);
  cut = isfinite (unknowns.sd) & ~unknowns.isScale;
  below = 1 - normalTail ((Q - unknowns.mean) ./ unknowns.sd);
  mass = unknowns.pHi - unknowns.pLo;
  if any (cut)
    share(:, cut) = (below(:, cut) - unknowns.pLo(cut)) ./ mass(cut);
  end
  U = sqrt (2) * erfinv (2 * min (max (share, 0), 1) - 1);
  is = unknowns.isScale;
  if any (is)
    U(:, is) = (log (Q(:, is)) - unknowns.mean(is)) ./ unknowns.sd(is);
  end
  % these are starts: at a limit the map is flat, and a fit would stay there
  U = min (max (U, -3), 3);
end

%!test
%! unknowns = struct ('lo', [-1, 0], 'hi', [1, 1], 'mean', [0, 0], 'sd', ...
%!                    [Inf, 0.5], 'isScale', [false, false], ...
%!                    'pLo', [0.5, 0.5], 'pHi', [0.5, 0.97725]);
%! assert (toNormal (unknowns, [0, 0]), [0, -3], 1e-12);
%! assert (toNormal (unknowns, [1, 1]), [3, 3]);

% SPDX-License-Identifier: GPL-3.0-only
