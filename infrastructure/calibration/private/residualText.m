% RESIDUALTEXT  Residuals in percent as text, each with its name.
%
% CALL: TEXT = residualText (RESIDUAL, NAMES)
%
%   RESIDUAL  T x 1; NaN: not measured yet;  NAMES  1 x T cell
%   TEXT      ' force -13.8, mass 0.9 and 3 smaller ones': the four largest

function text = residualText (residual, names)
  known = find (isfinite (residual(:)'));
  [~, order] = sort (-abs (residual(known)));
  shown = known(order(1:min (4, end)));
  parts = arrayfun (@(t) sprintf ('%s %.3g', names{t}, 100 * residual(t)), shown, ...
                    'UniformOutput', false);
  text = [' ', strjoin(parts, ', ')];
  if numel (known) > numel (shown)
    text = sprintf ('%s and %d smaller ones', text, numel (known) - numel (shown));
  end
end

%!assert (residualText ([0.01; NaN; -0.2], {'a', 'b', 'c'}), ' c -20, a 1')
%!assert (residualText (-0.01 * (1:6)', {'a', 'b', 'c', 'd', 'e', 'f'}), ...
%!        ' f -6, e -5, d -4, c -3 and 2 smaller ones')

% SPDX-License-Identifier: GPL-3.0-only
