% FITEFFECTS  Fits one effect, or two together, to one data set.
%
% CALL: FIT = fitEffects (HYPOTHESES, FITS, I, MEMBERS, PRIOR)
%
%   HYPOTHESES, FITS  of makeHypotheses, fitLibrary;  I  row of the data set
%   MEMBERS       1 x 1 or 1 x 2, numbers of the effects
%   PRIOR         HYPOTHESES.prior, or the same with flat, see fitHypothesis
%   FIT           struct of fitHypothesis with Z, logSum and hasOther as of
%                 fitLibrary. A single effect starts from its fit in FITS, a
%                 pair from either effect with a little of the other and from
%                 half of both; the best one counts

function best = fitEffects (hypotheses, fits, i, members, prior)
  p = hypotheses.white.p;
  U = fits.of{hypotheses.singles(members(1))}.U(i, :);
  kind = 'single';
  if numel (members) > 1
    kind = 'pair';
    a = U;
    b = fits.of{hypotheses.singles(members(2))}.U(i, :);
    U = [a(1:p + 1), -0.5, 0, a(end); b(1:p), -0.5, b(p + 1), 0, b(end); ...
         (a(1:p) + b(1:p)) / 2, a(p + 1) - 0.3, b(p + 1) - 0.3, 0, a(end)];
  end
  h = newHypothesis (kind, members);
  if isfield (prior, 'flat')
    % what DEM is given has the form of the library
    h.extent = 1e-6;
  end
  fit = fitHypothesis (hypotheses.white, h, repmat (fits.Z(i, :), rows (U), 1), ...
                       U, prior);
  score = fit.logE;
  if isfield (prior, 'flat')
    % without a prior Laplace's volume means nothing: the best fit is the best
    score = fit.logPeak;
  end
  [~, at] = max (score);
  best = struct ('U', fit.U(at, :), 'Q', fit.Q(at, :), 'A', fit.A(at, :, :), ...
                 'Z', fits.Z(i, :), 'logSum', fit.logE(at), ...
                 'hasOther', false);
end

%!test
%! % both effects of the hand-made laboratory at once
%! hypotheses = handMadeHypotheses ();
%! z = 0.5 * [3, 1, 0, 0] + [0, 0, 2.4, 2.4 - 2];
%! fits = fitLibrary (hypotheses, z);
%! fit = fitEffects (hypotheses, fits, 1, [1, 2], hypotheses.prior);
%! assert (fit.Q(1:2), [0.5, 0.6], 0.15);
%! assert (fit.Q(3) > 0.3 && fit.Q(3) < 0.5);    % a form error takes a part
%! flat = setfield (hypotheses.prior, 'flat', true);
%! assert (fitEffects (hypotheses, fits, 1, [1, 2], flat).Q(1:3), ...
%!         [0.5, 0.6, 0.5], 0.15);
%! assert (fitEffects (hypotheses, fits, 1, 1, hypotheses.prior).U, fits.of{2}.U, 0.01);

% SPDX-License-Identifier: GPL-3.0-only
