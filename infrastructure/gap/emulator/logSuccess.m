% LOGSUCCESS  Logarithm of the probability that all benches give a result.
%
% CALL: L = logSuccess (WHITE, H, Q)
%
%   WHITE  struct of whitenEmulator: success ((1 + p) x B), effect.success (2 x
%          B), see learnSuccess; without the field every run succeeds
%   H      1 x h, numbers of the active effects
%   Q      n x (p + h or more), parameters in [-1, 1] and strengths
%   L      n x 1
%
% See also: learnSuccess, integrateEvidence

function L = logSuccess (white, h, Q)
  L = zeros (rows (Q), 1);
  if ~isfield (white, 'success') || ~any (white.success(:))
    return
  end
  at = any (white.success, 1);
  p = rows (white.success) - 1;
  x = [ones(rows (Q), 1), Q(:, 1:p)] * white.success(:, at);
  for i = 1:numel (h)
    phi = Q(:, p + i);
    x = x + [abs(phi), phi] * white.effect(h(i)).success(:, at);
  end
  L = -sum (log1p (exp (-min (max (x, -30), 30))), 2);
end

%!test
%! white = struct ('success', [0, 1; 0, 2], 'effect', ...
%!                 struct ('success', [0, -1; 0, 0]));
%! assert (logSuccess (white, [], 0.5), -log1p (exp (-2)), 1e-12);
%! assert (logSuccess (white, 1, [0.5, 1]), -log1p (exp (-1)), 1e-12);
%! assert (logSuccess (struct ('success', zeros (2)), [], [1; 2]), [0; 0]);
