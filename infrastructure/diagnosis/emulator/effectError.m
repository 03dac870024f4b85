% EFFECTERROR  Covariance of what surrogates of effects may be wrong by.
%
% CALL: R = effectError (EMULATOR, MEMBERS, Q)
%
%   EMULATOR  struct of fitEmulator
%   MEMBERS  1 x h, numbers of the effects
%   Q        1 x (p + h), parameters in [-1, 1] and strengths
%   R        T x T: of each its surrogate, alike along a curve, and what few
%            runs leave open of its size (amplitudeSd)

function R = effectError (emulator, members, q)
  p = emulator.p;
  R = zeros (columns (emulator.coef));
  for i = 1:numel (members)
    e = emulator.effect(members(i));
    phi = q(p + i);
    S = predictGap (emulator, members(i), q([1:p, p + i])) - ...
        predictGap (emulator, [], q(1:p));
    psi = sign (phi) * abs (phi)^e.bend;
    sd = sqrt (effectVariance (e, polyRows (e.powers, [q(1:p), psi]), psi));
    % neighbours on a curve are read off the same runs: what their surrogates miss is
    % alike
    R = R + (sd' * sd) .* emulator.misfitLikeness;
    % a wrong size is one factor on the whole mark: all targets are off together
    R = R + amplitudeSd (e, phi)^2 * (S' * S);
  end
end

%!test
%! % of its surrogate 3^2 on target 2; of its size 0.5 of what it adds
%! e = struct ('name', 'a', 'powers', [0, 1], 'coef', [4, 0], 'bend', 1, ...
%!             'unbent', 1, 'strongest', 1, 'misfit', [0, 9], ...
%!             'root', zeros (1, 0), 'ofTarget', zeros (0, 2));
%! emulator = setfield (handMadeEmulator ([0, 0; 1, 0]), 'effect', e);
%! assert (effectError (emulator, 1, [0, 1]), [4, 0; 0, 9], 1e-12);
%! assert (effectError (emulator, [], 0), zeros (2));

% SPDX-License-Identifier: GPL-3.0-only
