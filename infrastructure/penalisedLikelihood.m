% PENALISEDLIKELIHOOD  Restricted likelihood of stk plus a weak normal prior.
%
% CALL: [C, dParam, dNoise] = penalisedLikelihood (model, X, z, prior)
%
% model  stk prior model with parameters and lognoisevariance
% X      n x d   inputs in the unit box
% z      n x 1   standardised response
% prior  struct: mean (k x 1), sd (k x 1) of the covariance parameters as stk
%        holds them (log variance, log 1/range), noiseMean, noiseSd of the log
%        noise variance
% C      scalar, negative log density; dParam, dNoise: its gradient
%
% With few runs per parameter the plain likelihood lets the noise collapse to
% zero and the ranges run away; a weak prior (a factor of e and more either
% way) costs nothing when the data speak. The form is a criterion of
% stk_param_estim.
%
% See also: fitSurrogate, stk_param_relik, stk_param_estim

function [C, dParam, dNoise] = penalisedLikelihood (model, X, z, prior)
  if nargout < 2
    C = stk_param_relik (model, X, z);
  else
    [C, dParam, dNoise] = stk_param_relik (model, X, z);
  end
  u = (model.param(:) - prior.mean(:)) ./ prior.sd(:);
  C = C + 0.5 * sum (u.^2);
  noiseFree = ~isscalar (model.lognoisevariance);
  if ~noiseFree
    w = (model.lognoisevariance - prior.noiseMean) / prior.noiseSd;
    C = C + 0.5 * w^2;
  end
  if nargout > 1
    dParam = dParam + u ./ prior.sd(:);
    if ~noiseFree
      dNoise = dNoise + w / prior.noiseSd;
    end
  end
end

%!test
%! % gradient agrees with central differences
%! pkg load stk
%! rand ('twister', 1);
%! X = rand (9, 2);
%! z = X(:, 1) - X(:, 2) .^ 2;
%! m = stk_model ('stk_materncov52_aniso', 2);
%! m.lm = stk_lm_affine ();
%! m.param = [-1; 0.2; -0.3];
%! m.lognoisevariance = -4;
%! q = struct ('mean', [0; 0; 0], 'sd', [1; 2; 3], 'noiseMean', -5, ...
%!             'noiseSd', 2);
%! [C, g, gn] = penalisedLikelihood (m, X, z, q);
%! h = 1e-5;
%! up = m;
%! dn = m;
%! up.param(2) = up.param(2) + h;
%! dn.param(2) = dn.param(2) - h;
%! d = penalisedLikelihood (up, X, z, q) - penalisedLikelihood (dn, X, z, q);
%! assert (g(2), d / (2 * h), 1e-5);
%! up = m;
%! dn = m;
%! up.lognoisevariance = -4 + h;
%! dn.lognoisevariance = -4 - h;
%! d = penalisedLikelihood (up, X, z, q) - penalisedLikelihood (dn, X, z, q);
%! assert (gn, d / (2 * h), 1e-5);
