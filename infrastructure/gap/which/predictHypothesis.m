% PREDICTHYPOTHESIS  Predicts results under a hypothesis, in normal coordinates.
%
% CALL: [M, V, L, J, G] = predictHypothesis (VIEW, U)
%
%   VIEW      struct of viewHypothesis
%   U         n x d, normal coordinates (fromNormal)
%   M, V      n x T, mean and variance of the whitened results
%   L         n x 1, log probability that all benches give a result (see
%             fitEmulator; 0 where no run has failed)
%   J         1 x d cell of n x T, slopes of M along U
%   G         n x T, slope of log V along the last coordinate where H has a
%             spread, else 0
%
% Few runs do not tell how an effect bends: its signature is S exp (a g), a ~ N
% (0, 1) an unknown, g its deviation, which grows away from the strongest run.
% Where there are eight runs or more, g is 0.
%
% A sibling of effects with signature s adds size^2 |N' s|^2 / n to every
% variance: an unknown direction among the n that parameters cannot absorb. A
% discrepancy adds size^2 VIEW.white.shape.

function [M, V, L, J, G] = predictHypothesis (view, U)
  white = view.white;
  h = view.h;
  [Q, slope] = fromNormal (view.unknowns, U);
  last = white.p + numel (h.members);
  L = logSuccess (white, h.members, Q);
  G = 0;
  if nargout > 3
    [M, V, S, J] = predictGap (white, h.members, Q(:, 1:last));
    for j = 1:last
      J{j} = J{j} .* slope(:, j);
    end
  else
    [M, V, S] = predictGap (white, h.members, Q(:, 1:last));
  end
  if ~isempty (h.members)
    last = last + 1;
    J{last} = zeros (size (S));
    if any ([white.effect(h.members).unbent])
      g = amplitudeSd (white.effect(h.members), Q(:, white.p + 1:last - 1));
      larger = exp (Q(:, last) .* g);
      M = M + (larger - 1) .* S;
      J{last} = g .* larger .* S;
    end
  end
  if isempty (h.spread)
    return
  end
  if strcmp (h.spread, 'sibling')
    % no direction is left where there are no more results than parameters
    part = Q(:, end).^2 .* sum ((S * white.parity).^2, 2) / ...
           max (1, columns (white.parity)) .* white.isTarget;
  else
    part = Q(:, end).^2 .* white.shape;
  end
  V = V + part;
  if nargout > 3
    J{last + 1} = 0;
    G = 2 * part ./ V .* slope(:, end) ./ Q(:, end);
  end
end

function L = logSuccess (white, members, Q)
  L = zeros (rows (Q), 1);
  at = any (white.success, 1);
  if ~any (at)
    return
  end
  p = white.p;
  x = [ones(rows (Q), 1), Q(:, 1:p)] * white.success(:, at);
  for i = 1:numel (members)
    phi = Q(:, p + i);
    x = x + [abs(phi), phi] * white.effect(members(i)).success(:, at);
  end
  L = -sum (log1p (exp (-min (max (x, -30), 30))), 2);
end

%!shared white, prior
%! white = handMadeHypotheses ().white;
%! prior = struct ('mean', 0, 'sd', Inf);
%!test
%! % slopes against differences
%! h = newHypothesis ('pair', [1, 2]);
%! view = viewHypothesis (white, h, prior);
%! U = [0.2, -0.3, 0.4, 0];
%! [M, V, L, J] = predictHypothesis (view, U);
%! assert (L, 0);
%! for j = 1:4
%!   step = 1e-6 * ((1:4) == j);
%!   up = predictHypothesis (view, U + step);
%!   down = predictHypothesis (view, U - step);
%!   assert (J{j} + zeros (1, 4), (up - down) / 2e-6, 1e-6);
%! end
%!test
%! % a sibling at tangent 2 of a signature of size 4 sqrt (2) phi in three
%! % directions
%! h = newHypothesis ('sibling', 1, [2, 1e-9]);
%! view = viewHypothesis (white, h, prior);
%! U = toNormal (view.unknowns, [0.5, 0.5, 0, 2]);
%! [~, V, ~, ~, G] = predictHypothesis (view, U);
%! assert (V, 1 + 4 * 8 / 3 * ones (1, 4), 1e-6);
%! assert (max (abs (G)) < 1e-8);
%!test
%! % as many parameters as results: there is no direction for it, no NaN
%! white.parity = zeros (4, 0);
%! view = viewHypothesis (white, newHypothesis ('sibling', 1), prior);
%! [M, V, ~, ~, G] = predictHypothesis (view, [0.2, -0.3, 0, 0.1]);
%! assert (V, ones (1, 4), 1e-12);
%! assert (G, zeros (1, 4));
%!test
%! % one of two benches has failed where the parameter or effect 1 is strong
%! white.success = [0, 1; 0, 2];
%! white.effect(1).success = [0, -1; 0, 0];
%! view = viewHypothesis (white, newHypothesis ('single', 1), prior);
%! U = toNormal (view.unknowns, [0.5, 0.9, 0]);
%! [~, ~, L] = predictHypothesis (view, U);
%! assert (L, -log1p (exp (-2 + 0.9)), 1e-12);
