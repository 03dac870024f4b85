% RESIDUALTEXT  Residuals in percent as text, each with its name.
%
% CALL: TEXT = residualText (RESIDUAL, NAMES [, TOL])
%
%   RESIDUAL  T x 1; NaN: not measured yet;  NAMES  1 x T cell
%   TOL       1 x T, tolerances of targets whose residual is no share, but has the unit
%             of the value (NaN: it is one)
%   TEXT      ' force -13.8, mass 0.9, drift 0.4 tolerances and 3 smaller ones': the four
%             largest, absolute ones in tolerances

function text = residualText (residual, names, tol)
  isShare = true (size (residual));
  if nargin > 2
    isShare(:) = isnan (tol);
    residual(~isShare) = residual(~isShare) ./ tol(~isShare)(:);
  end
  known = find (isfinite (residual(:)'));
  [~, order] = sort (-abs (residual(known)));
  shown = known(order(1:min (4, end)));
  parts = cell (1, 0);
  for t = shown
    if isShare(t)
      parts{end + 1} = sprintf ('%s %.3g', names{t}, 100 * residual(t));
    else
      parts{end + 1} = sprintf ('%s %.3g tolerances', names{t}, residual(t));
    end
  end
  text = [' ', strjoin(parts, ', ')];
  if numel (known) > numel (shown)
    text = sprintf ('%s and %d smaller ones', text, numel (known) - numel (shown));
  end
end

%!assert (residualText ([0.01; NaN; -0.2], {'a', 'b', 'c'}), ' c -20, a 1')
%!assert (residualText ([-0.03; 0.02], {'a', 'b'}, [0.1, NaN]), ' a -0.3 tolerances, b 2')
%!assert (residualText (-0.01 * (1:6)', {'a', 'b', 'c', 'd', 'e', 'f'}), ...
%!        ' f -6, e -5, d -4, c -3 and 2 smaller ones')

% SPDX-License-Identifier: GPL-3.0-only
