% BLINDSPACE  What of a change the parameters cannot absorb, at one point.
%
% CALL: SPACE = blindSpace (LAB, THETA)
%
%   LAB     struct of blindLab
%   THETA   1 x p, parameters in [0, 1]
%   SPACE   struct
%     base     1 x T, results without an effect, of all targets
%     freedom  how many directions are left to see a change in
%     visible  handle, D = VISIBLE (SHAPE): signal to noise (reading, packings
%              of both sides, surrogate) of a 1 x T change
%     parts    handle, R = PARTS (SHAPE): what is left of it per target, 1 x T,
%              in standard deviations of that target; 0 where it is held out
%     shape    handle, S = SHAPE (K, PHI): 1 x T change by listed effect K
%
% See also: blindLab, twinsSpace, parityProjection

function space = blindSpace (lab, theta)
  white = lab.hypotheses.white;
  q = 2 * theta - 1;
  [~, V, ~, J] = predictGap (white, [], q);
  slopes = vertcat (J{:})' ./ sqrt (V');
  N = parityProjection (slopes, zeros (numel (V), 1)).N;
  used = white.columns;
  whitened = @(shape) (shape(used) * white.W' ./ sqrt (V))';
  space.base = predictGap (lab.emulator, [], q);
  space.freedom = columns (N);
  space.visible = @(shape) norm (N' * whitened (shape));
  back = inv (white.W) .* sqrt (V);
  scale = sqrt (sum (back.^2, 2));
  space.parts = @(shape) spread ((back * (N * (N' * whitened (shape))) ./ ...
                                  scale)', used, columns (shape));
  space.shape = @(k, phi) predictGap (lab.emulator, k, [q, phi]) - space.base;
end

function parts = spread (values, used, T)
  parts = zeros (1, T);
  parts(used) = values;
end

%!test % a laboratory of formulas: what a parameter can do is invisible
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! options = gapOptions ([]);
%! problem = newProblem (given);
%! emulator = fitEmulator (problem, data, options);
%! lab = struct ('emulator', emulator, ...
%!               'hypotheses', makeHypotheses (problem, emulator, options));
%! space = blindSpace (lab, [0.5, 0.5]);
%! near = predictGap (emulator, [], [0.02, 0]) - space.base;
%! full = space.shape (1, 1);
%! assert (space.visible (near) < 0.1 * norm (near ./ problem.sd));
%! assert (space.visible (2 * full), 2 * space.visible (full), 1e-9);
%! assert (size (space.parts (full)), size (space.base));
