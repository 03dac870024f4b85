% PREDICTGAP  Predicts results and variances under a hypothesis, with slopes.
%
% CALL: [M, V, J] = predictGap (WHITE, H, Q)
%
%   WHITE  struct of whitenEmulator, or of fitEmulator if only M is asked for
%   H      1 x h, numbers of the active effects ([]: null model)
%   Q      n x (p + h), parameters in [-1, 1] and strengths of the effects
%   M      n x T, mean; effects add up
%   V      n x T, variance: noise, baseline surrogate and effect surrogates
%   J      1 x (p + h) cell of n x T, slopes of M
%
% A field extra (1 x T) of WHITE is added to V: a discrepancy without a name.
%
% See also: whitenEmulator, fitHypothesis

function [M, V, J] = predictGap (white, h, Q)
  p = white.p;
  theta = Q(:, 1:p);
  M = polyRows (white.powers, theta) * white.coef;
  if nargout > 1
    V = exp (polyRows (white.varPowers, theta) * white.varCoef);
  end
  if nargout > 1 && isfield (white, 'extra')
    V = V + white.extra;
  end
  J = cell (1, p + numel (h));
  if nargout > 2
    for j = 1:p
      J{j} = polySlope (white.powers, white.coef, theta, j);
    end
  end
  for i = 1:numel (h)
    e = white.effect(h(i));
    q = [theta, Q(:, p + i)];
    M = M + polyRows (e.powers, q) * e.coef;
    if nargout > 1 && ~e.laboratory
      V = V + q(:, end).^2 .* exp (polyRows (e.varPowers, q) * e.varCoef);
    end
    if nargout > 2
      for j = 1:p
        J{j} = J{j} + polySlope (e.powers, e.coef, q, j);
      end
      J{p + i} = polySlope (e.powers, e.coef, q, p + 1);
    end
  end
end

%!test
%! white = handMadeModels ().white;
%! [M, V, J] = predictGap (white, [1, 2], [0.5, 0.25, 1]);
%! assert (M, [1.5, 0.5, 1, -3]);
%! assert (V, ones (1, 4));
%! assert (J{1}, [3, 1, 0, 0]);
%! assert (J{3}, [0, 0, 0, -4]);
%! white.extra = 2 * ones (1, 4);
%! [~, V] = predictGap (white, [], 0);
%! assert (V, 3 * ones (1, 4));
