% HYPOTHESISBOX  Gives limits and prior of the unknowns of a hypothesis.
%
% CALL: BOX = hypothesisBox (WHITE, H, PRIOR)
%
%   WHITE  struct of whitenEmulator
%   H      1 x h, numbers of the active effects
%   PRIOR  struct mean, precision (1 x p, parameters in [-1, 1]; precision 0 =
%          uniform), widen (scalar factor on the scale of the effects)
%   BOX    struct lo, hi, mean, precision, logConstant (logarithm of the prior
%          density where the quadratic part is zero), all 1 x (p + h)
%
% Parameters: uniform in the box, or normal cut to the box where measured.
% Strengths: normal around neutral cut to the range of the effect.
%
% See also: fitHypothesis, integrateEvidence

function box = hypothesisBox (white, h, prior)
  p = white.p;
  box.lo = -ones (1, p);
  box.hi = ones (1, p);
  box.mean = prior.mean;
  box.precision = prior.precision;
  for k = h(:)'
    box.lo(end + 1) = white.effect(k).range(1);
    box.hi(end + 1) = white.effect(k).range(2);
    box.mean(end + 1) = 0;
    box.precision(end + 1) = 1 / (prior.widen * white.effect(k).scale)^2;
  end
  root = sqrt (box.precision);
  mass = normalTail ((box.lo - box.mean) .* root) - ...
         normalTail ((box.hi - box.mean) .* root);
  box.logConstant = 0.5 * log (box.precision / (2 * pi)) - log (mass);
  flat = box.precision == 0;
  box.logConstant(flat) = -log (box.hi(flat) - box.lo(flat));
end

%!test
%! white = struct ('p', 1, 'effect', struct ('range', [0, 1], 'scale', 100));
%! prior = struct ('mean', 0, 'precision', 0, 'widen', 1);
%! box = hypothesisBox (white, 1, prior);
%! assert (box.logConstant, [-log(2), 0], 1e-4);
%! assert ([box.lo; box.hi], [-1, 0; 1, 1]);
