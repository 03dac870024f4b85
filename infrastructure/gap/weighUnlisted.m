% WEIGHUNLISTED  Computes the evidence that the cause is not on the list.
%
% CALL: H = weighUnlisted (MODELS, FITS, I)
%
%   MODELS  struct of makeModels
%   FITS    struct of fitLibrary
%   I       scalar, row of the data set
%   H       struct like a hypothesis of weighCase; kindShare (1 x m) says which
%           discrepancy carries it
%
% The parameters are integrated by importance sampling at the mode of each kind,
% the size tau of the discrepancy by a sum over its grid.
%
% See also: unlistedKinds, weighCase

function h = weighUnlisted (models, fits, i)
  m = numel (models.kinds);
  part = zeros (1, m);
  ess = zeros (1, m);
  for k = 1:m
    kind = models.kinds(k);
    box = hypothesisBox (kind.white, [], models.prior);
    A = squeeze (fits.kind{k}.A(i, :, :)) + diag (3 * (box.precision == 0));
    mode = struct ('Q', fits.kind{k}.Q(i, :), 'A', A / 1.5);
    [part(k), ess(k)] = overSizes (kind, fits.rotated{k}(i, :), mode, box, ...
                                   models.base);
  end
  weighted = part + log ([models.kinds.weight]);
  h = struct ('kind', 'unlisted', 'members', [], ...
              'logE', logSumExp (weighted), 'error', 0, ...
              'ess', min (ess), 'phi', NaN (1, 3), 'atLimit', 0, 'fitP', 1, ...
              'vague', 0);
  h.posterior = struct ('Q', [], 'weight', ...
                        exp (weighted - logSumExp (weighted)));
end

function [logE, ess] = overSizes (kind, z, mode, box, base)
  n = min (500, rows (base.normal));
  few = struct ('normal', base.normal(1:n, :), ...
                'uniform', base.uniform(1:n, :), 'root', base.root(1:n));
  points = proposalPoints (mode, box, few);
  white = rmfield (kind.white, 'extra');
  [M, V] = predictGap (white, [], points.Q);
  R = (z - M).^2;
  logW = zeros (rows (R), numel (kind.tau));
  for s = 1:numel (kind.tau)
    total = V + kind.tau(s)^2 * kind.shape;
    logW(:, s) = -0.5 * sum (R ./ total + log (2 * pi * total), 2);
  end
  logW = logSumExp (logW) - log (numel (kind.tau)) + sum (box.logConstant) - ...
         0.5 * sum (box.precision .* (points.Q - box.mean).^2, 2) - ...
         points.logP;
  total = logSumExp (logW');
  logE = total - log (n);
  ess = 1 / sum (exp (2 * (logW - total)));
end

%!test
%! % a misfit along no effect: the unlisted cause wins over null and effects
%! models = handMadeModels ();
%! w = weighCase (models, fitLibrary (models, [1.5, 0.5, -6, 5]), 1, true);
%! assert (w.logE(end) > max (w.logE(1:end - 1)));
