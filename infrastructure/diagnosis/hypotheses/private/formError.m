% FORMERROR  Whitens an emulator so that errors of form have no correlations.
%
% CALL: WHITE = formError (PROBLEM, EMULATOR, BUDGET, TARGETS)
%
%   PROBLEM, EMULATOR, BUDGET     of newProblem, fitEmulator, noiseBudget
%   TARGETS  1 x n, targets to look at
%   WHITE    struct of whitenEmulator, its coordinates turned, with shape (1 x n,
%            sum 1; 0 without effects): how the error of form is shared among
%            them
%
% What an effect does is not what its law in the library makes of it. The error
% is normal, its size that of the mark times the tangent of an angle (see
% newHypothesis), its covariance the same for all effects and pairs, and for all
% conditions of a case:
%   half of it towards other listed marks, N w w' N' / |w|^2 in the mean over
%   all pairs of effects, w the part of one mark at right angles to the other;
%   half of it smooth along benches and curves, with the sizes and signs of the marks:
%   a result whose sign is turned is the same result.
% Marks are seen ones: N, the directions that parameters cannot absorb in the
% middle of the box, in units of the noise. Those that cannot be seen (size
% below 1) tell no direction.

function white = formError (problem, emulator, budget, targets)
  white = whitenEmulator (emulator, targets, budget);
  isTarget = white.isTarget > 0;
  W = white.W(isTarget, :);
  S = middleMarks (emulator, targets);
  N = white.parity;
  V = N(isTarget, :)' * W * S';
  if isempty (S)
    white.shape = zeros (size (isTarget));
    return
  end
  smooth = W * smoothOver (problem, targets, S) * W';
  smooth = N(isTarget, :)' * smooth * N(isTarget, :);
  C = unitTrace (smooth) + unitTrace (towardsOthers (V));
  C = unitTrace (N(isTarget, :) * C * N(isTarget, :)');
  C = (C + C') / 2;
  % of directions without an error eig would take any, another one with each
  % rounding: a little that differs from one to the next fixes them
  m = rows (C);
  [U, ~] = eig (C + 1e-6 * diag ((1:m) / m));
  white = whitenEmulator (emulator, targets, budget, U');
  white.shape = zeros (size (isTarget));
  white.shape(isTarget) = max (sum (U .* (C * U), 1), 0);
end

function C = unitTrace (C)
  C = C / max (trace (C), realmin);
end

function C = towardsOthers (V)
  % a mark below the noise has no direction that anybody could tell
  V = V(:, sum (V.^2, 1) > 1);
  C = zeros (rows (V));
  for k = 1:columns (V)
    u = V(:, k) / norm (V(:, k));
    R = V - u * (u' * V);
    % of nearly parallel marks (sine below 0.2) the rest has no sure direction
    R = R(:, sum (R.^2, 1) > 0.04 * sum (V.^2, 1));
    R = R ./ sqrt (sum (R.^2, 1));
    C = C + R * R';
  end
end

% Half alike on a bench, the rest alike over a third of a curve, or alone.
function C = smoothOver (problem, targets, S)
  bench = problem.bench(targets);
  C = 0.5 * (bench' == bench) + 0.1 * eye (numel (targets));
  near = fadingAlong (problem, targets);
  C = (C + 0.4 * near) .* (S' * S / rows (S));
end

%!test
%! % noise stays white; a form error is diagonal; half of it is towards the
%! % other effect, here target 4 for the first one
%! emulator = handMadeEmulator ([1, 2, 3, 0; 1, 0, 0, 0]);
%! emulator.range = ones (1, 4);
%! e = struct ('name', 'a', 'powers', [0, 1], 'coef', [0, 0, 9, 0], 'bend', ...
%!             1, 'range', [0, 1], 'scale', 1, 'unbent', 0, 'strongest', 1, ...
%!             'misfit', zeros (1, 4), 'root', zeros (1, 0), 'ofTarget', ...
%!             zeros (0, 4));
%! emulator.effect = [e, setfield(e, 'coef', [0, 0, 9, 9])];
%! given = struct ('value', 1:4, 'sd', ones (1, 4), 'limits', [0; 1], ...
%!                 'bench', [1, 1, 1, 2]);
%! budget = struct ('covariance', eye (4), 'doubt', zeros (2, 4), ...
%!                     'estimated', zeros (1, 4), ...
%!                  'unknown', zeros (1, 4));
%! white = formError (newProblem (given), emulator, budget, 1:4);
%! assert (white.W * white.W', eye (4), 1e-9);
%! assert (sum (white.shape), 1, 1e-9);
%! C = white.back * diag (white.shape) * white.back';
%! assert (C(1, 1), 0, 1e-9);        % the parameter takes it
%! assert (C(4, 4) > 0.25 && C(3, 3) > 0.1);
%! % coordinates do not hang on rounding, also where there is no error
%! emulator.coef(1:end, :) = emulator.coef .* (1 + 1e-13 * [1, -1, 1, -1]);
%! again = formError (newProblem (given), emulator, budget, 1:4);
%! assert (abs (again.W * white.back), eye (4), 1e-6);
%!test
%! % the same error of form for a result whose sign is turned
%! turn = [1, 1, 1, -1];
%! for sign_ = {ones(1, 4), turn}
%!   emulator = handMadeEmulator ([1, 2, 3, 0; 1, 0, 0, 0] .* sign_{1});
%!   emulator.range = ones (1, 4);
%!   emulator.effect = struct ('name', 'a', 'powers', [0, 1], 'coef', ...
%!                             [0, 2, 9, 8] .* sign_{1}, 'bend', 1, 'range', [0, 1], ...
%!                             'scale', 1, 'unbent', 0, 'strongest', 1, 'misfit', ...
%!                             zeros (1, 4), 'root', zeros (1, 0), 'ofTarget', ...
%!                             zeros (0, 4));
%!   given = struct ('value', 1:4, 'sd', ones (1, 4), 'limits', [0; 1], ...
%!                   'bench', [1, 1, 2, 2]);
%!   budget = struct ('covariance', eye (4), 'doubt', zeros (2, 4), ...
%!                     'estimated', zeros (1, 4), ...
%!                    'unknown', zeros (1, 4));
%!   white = formError (newProblem (given), emulator, budget, 1:4);
%!   C{1 + any (sign_{1} < 0)} = white.back * diag (white.shape) * white.back';
%! end
%! assert (C{2}, C{1} .* (turn' * turn), 1e-4);
%! assert (abs (C{1}(3, 4)) > 0.05);

% SPDX-License-Identifier: GPL-3.0-only
