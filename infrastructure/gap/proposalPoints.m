% PROPOSALPOINTS  Draws the points of an importance sample and their density.
%
% CALL: POINTS = proposalPoints (MODES, BOX, BASE)
%
%   MODES   struct array Q (1 x d), A (d x d, inverse covariance)
%   BOX     struct of hypothesisBox
%   BASE    struct of integrationPoints
%   POINTS  struct Q (m x d: those of the N points that lie in the box), logP
%           (m x 1: log density of the proposal)
%
% 90 % Student t with 5 degrees of freedom, shared by the modes, 10 % uniform.
%
% See also: integrateEvidence, weighUnlisted

function points = proposalPoints (modes, box, base)
  N = rows (base.normal);
  d = numel (box.lo);
  count = numel (modes);
  Q = box.lo + base.uniform(:, 1:d) .* (box.hi - box.lo);
  edges = round (linspace (round (0.1 * N), N, count + 1));
  for m = 1:count
    L{m} = chol (modes(m).A, 'lower');
    at = edges(m) + 1:edges(m + 1);
    Q(at, :) = modes(m).Q + (base.normal(at, 1:d) ./ base.root(at)) / L{m};
  end
  points.Q = Q(all (Q >= box.lo & Q <= box.hi, 2), :);
  parts = zeros (rows (points.Q), count + 1);
  parts(:, 1) = log (0.1) - sum (log (box.hi - box.lo));
  c = gammaln ((5 + d) / 2) - gammaln (2.5) - d / 2 * log (5 * pi);
  for m = 1:count
    distance = sum (((points.Q - modes(m).Q) * L{m}).^2, 2);
    parts(:, m + 1) = log (0.9 / count) + c + sum (log (diag (L{m}))) - ...
                      (5 + d) / 2 * log1p (distance / 5);
  end
  points.logP = logSumExp (parts);
end

%!test
%! % the weights of a flat target average to its volume
%! box = struct ('lo', [-1, 0], 'hi', [1, 1]);
%! base = integrationPoints (4000, 2, 1);
%! mode = struct ('Q', [0.2, 0.5], 'A', diag ([4, 16]));
%! points = proposalPoints (mode, box, base);
%! assert (sum (exp (-points.logP)) / 4000, 2, 0.1);
