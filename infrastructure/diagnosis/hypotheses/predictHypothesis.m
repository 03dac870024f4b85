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
%   G         1 x d cell of n x T, slopes of log V along U where H has a spread
%             (along its size and the strengths), else []: none
%
% Few runs do not tell how an effect bends: its signature is S exp (a g), a ~ N
% (0, 1) an unknown, g its deviation, which grows away from the strongest run.
% Where there are eight runs or more, g is 0.
%
% What effects do is not what their laws make of it: marks s_1, s_2 add size^2
% (|N' s_1|^2 + |N' s_2|^2) VIEW.white.shape to the variances, N the directions
% that parameters cannot absorb, shape that of formError. A discrepancy adds
% size^2 VIEW.white.shape.

function [M, V, L, J, G] = predictHypothesis (view, U)
  white = view.white;
  h = view.h;
  [Q, slope] = fromNormal (view.unknowns, U);
  last = white.p + numel (h.members);
  L = logSuccess (white, h.members, Q);
  [G, J] = deal ({});
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
      % log-normal: a mark may be twice or half as large, but not turn its sign
      larger = exp (Q(:, last) .* g);
      M = M + (larger - 1) .* S;
      J{last} = g .* larger .* S;
    end
  end
  if isempty (h.spread)
    return
  end
  energy = 1;
  if strcmp (h.spread, 'form')
    slopes = J(1:end * (nargout > 3));
    [energy, steep] = energyOf (white, h.members, Q, S, slopes);
  end
  part = Q(:, end).^2 .* energy .* white.shape;
  V = V + part;
  if nargout > 3
    % an unknown part widens the prediction and moves no mean
    J{last + 1} = 0;
    G = cell (1, last + 1);
    share = part ./ V;
    G{end} = 2 * share .* slope(:, end) ./ max (Q(:, end), 1e-6);
    for i = 1:numel (h.members)
      G{white.p + i} = share .* steep{i};
    end
  end
end

% What is seen of each effect, squared, all together; and the slope of its
% logarithm along the strengths, where slopes J are there.
function [energy, steep] = energyOf (white, members, Q, S, J)
  p = white.p;
  energy = 0;
  parts = {S};
  for i = 1:numel (members) * (numel (members) > 1)
    [~, ~, parts{i}] = predictGap (white, members(i), Q(:, [1:p, p + i]));
  end
  for i = 1:numel (parts)
    % squares of both add: either law is off in a direction of its own
    parts{i} = parts{i} * white.parity;
    energy = energy + sum (parts{i}.^2, 2);
  end
  steep = {};
  for i = 1:numel (J) - 1 - p
    slope = (J{p + i} + zeros (size (S))) * white.parity;
    steep{i} = 2 * sum (parts{i} .* slope, 2) ./ max (energy, realmin);
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
  % beyond 30 a chance of 1e-13 is none, and exp does not overflow
  L = -sum (log1p (exp (-min (max (x, -30), 30))), 2);
end

%!shared white, prior
%! white = handMadeHypotheses ().white;
%! prior = struct ('mean', 0, 'sd', Inf);
%!test
%! % slopes against differences
%! h = newHypothesis ('pair', [1, 2]);
%! view = viewHypothesis (white, h, prior);
%! U = [0.2, -0.3, 0.4, 0, 0.1];
%! [M, V, L, J] = predictHypothesis (view, U);
%! assert (L, 0);
%! for j = 1:5
%!   step = 1e-6 * ((1:5) == j);
%!   up = predictHypothesis (view, U + step);
%!   down = predictHypothesis (view, U - step);
%!   assert (J{j} + zeros (1, 4), (up - down) / 2e-6, 1e-6);
%! end
%!test
%! % a form error of tangent 2 of a mark of size 4 sqrt (2) phi, a third of it in
%! % each of three directions; its slopes against differences
%! white.shape = [0, 1, 1, 1] / 3;
%! view = viewHypothesis (white, newHypothesis ('single', 1), prior);
%! U = toNormal (view.unknowns, [0.5, 0.5, 0, 0.8]);
%! [~, V, ~, J, G] = predictHypothesis (view, U);
%! assert (V, 1 + 0.8^2 * 8 * white.shape, 1e-6);
%! for j = 1:4
%!   step = 1e-6 * ((1:4) == j);
%!   [~, up] = predictHypothesis (view, U + step);
%!   [~, down] = predictHypothesis (view, U - step);
%!   assert ([G{j}, zeros(1, 4 * isempty (G{j}))], log (up ./ down) / 2e-6, 1e-6);
%! end
%! % of a pair what each does, though together they do nothing
%! white.effect(2).coef = [0, 0, -4, -4];
%! view = viewHypothesis (white, newHypothesis ('pair', [1, 2]), prior);
%! U = toNormal (view.unknowns, [0.5, 0.5, 0.5, 0, 0.8]);
%! [M, V] = predictHypothesis (view, U);
%! assert (M, [1.5, 0.5, 0, 0], 1e-9);
%! assert (V, 1 + 0.8^2 * 16 * white.shape, 1e-6);
%!test
%! % as many parameters as results: there is no direction for it, no NaN
%! white.parity = zeros (4, 0);
%! view = viewHypothesis (white, newHypothesis ('single', 1), prior);
%! [~, V, ~, ~, G] = predictHypothesis (view, [0.2, -0.3, 0, 0.1]);
%! assert (V, ones (1, 4), 1e-12);
%! assert (G{4}, zeros (1, 4));
%!test
%! % one of two benches has failed where the parameter or effect 1 is strong
%! white.success = [0, 1; 0, 2];
%! white.effect(1).success = [0, -1; 0, 0];
%! view = viewHypothesis (white, newHypothesis ('single', 1), prior);
%! U = toNormal (view.unknowns, [0.5, 0.9, 0, 0.1]);
%! [~, ~, L] = predictHypothesis (view, U);
%! assert (L, -log1p (exp (-2 + 0.9)), 1e-12);

% SPDX-License-Identifier: GPL-3.0-only
