% TURNMARK  Turns what a cause makes away from the form of its law.
%
% CALL: SHIFT = turnMark (HYPOTHESES, PROBLEM, THETA, PHI, WAY, SEED)
%
%   HYPOTHESES, PROBLEM     of makeHypotheses, newProblem
%   THETA    1 x p, parameters in [-1, 1];  PHI  struct at (number of the
%            cause), strength
%   WAY      'rival': towards another listed effect, drawn by SEED; 'smooth':
%            along benches and curves
%   SHIFT    1 x T', times the tangent of the angle by which what is seen of the
%            cause is to turn: to be added to the values of the targets
%
% What is seen: the part that parameters cannot absorb, in units of the noise.
% The part that is added is at right angles to the mark.
%
% See also: formStudy

function shift = turnMark (hypotheses, problem, theta, phi, way, seed)
  white = hypotheses.white;
  [~, V, ~, J] = predictGap (white, [], theta);
  sd = sqrt (V);
  slopes = reshape (vertcat (J{:})', numel (V), white.p) ./ sd';
  N = parityProjection (slopes, zeros (numel (V), 1)).N;
  markOf = @(k, strength) seen (white, N, sd, k, [theta, strength]);
  u = markOf (phi.at, phi.strength);
  others = setdiff (1:numel (white.effect), phi.at);
  restore = seedRandom (seed);
  others = others(randperm (numel (others)));
  w = zeros (size (u));
  if strcmp (way, 'smooth')
    others = [];
    w = N' * ((smoothDraw (problem, white) * white.W') ./ sd)';
    w = w - u * (u' * w) / (u' * u);
  end
  for k = others
    v = markOf (k, white.effect(k).range(2));
    w = v - u * (u' * v) / (u' * u);
    if norm (v) > 1 && norm (w) > 0.2 * norm (v)
      break
    end
  end
  w = norm (u) * w / max (norm (w), realmin);
  shift = ((N * w)' .* sd) * white.back';
end

function u = seen (white, N, sd, k, q)
  [~, ~, S] = predictGap (white, k, q);
  u = N' * (S ./ sd)';
end

% Alike along curves (over a third of them) and on benches, in units of the
% uncertainty.
function x = smoothDraw (problem, white)
  at = white.columns;
  bench = problem.bench(at);
  C = 0.5 * (bench' == bench) + 0.1 * eye (numel (at));
  for s = setdiff (problem.series(at), 0)
    own = find (problem.series(at) == s);
    where = problem.coordinate(at)(own);
    apart = abs (where' - where) / max ((max (where) - min (where)) / 3, ...
                                        realmin);
    C(own, own) = C(own, own) + 0.4 * exp (-apart);
  end
  alone = problem.series(at) == 0;
  C = C + 0.4 * diag (alone);
  x = randn (1, numel (at)) * chol (C) .* problem.sd(at);
end

% SPDX-License-Identifier: GPL-3.0-only
