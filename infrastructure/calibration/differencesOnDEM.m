% DIFFERENCESONDEM  Jacobian of the cost function by runs: finite differences.
%
% CALL: J = differencesOnDEM (P, F, RESPOND, KEPT, STATE, PROBLEM)
%
% P        1 x d, set;  F  k x 1, its residuals (rows KEPT of costFunction)
% RESPOND  handle Z = f (P): n x d sets -> n x T responses; makes the runs
% STATE    struct of newState: its surrogates know the scatter of a run
% PROBLEM  struct of newProblem
% J        k x d, by the parameters in the unit box
%
% Forward differences as published, but for the step: it moves the responses by
% 4 times the scatter of one run, as a smaller one would measure that scatter
% (between 2 and 20 % of the box); and the d runs go out as one batch. Where a
% run fails, the derivative is that of the surrogates.
%
% See also: calibrateOnDEM, surrogateJacobian

function J = differencesOnDEM (p, f, respond, kept, state, problem)
  lo = problem.limits(1, :);
  width = diff (problem.limits);
  u = (p - lo) ./ width;
  step = stepsOf (state.surrogates, problem, p);
  step(u + step > 1) = -step(u + step > 1);
  P = lo + (u + full (diag (step))) .* width;
  Z = respond (P);
  onKriging = @(q) evaluateKriging (q, state.surrogates);
  J = zeros (numel (f), numel (p));
  for j = 1:numel (p)
    base = f;
    z = Z(j, :)';
    if any (isnan (z))
      z = onKriging (P(j, :));
      base = rowsAt (problem, p, onKriging (p), kept);
    end
    J(:, j) = (rowsAt (problem, P(j, :), z, kept) - base) / step(j);
  end
end

function r = rowsAt (problem, p, z, kept)
  r = problem.cost (p(:), @(varargin) z(:))(kept)(:);
end

function step = stepsOf (surrogates, problem, p)
  use = problem.calibrate;
  [~, slope] = targetResidual (problem, p, predictSurrogate (surrogates, p));
  noise = sqrt ([surrogates(use).noiseVar]) .* abs (slope(use)) ./ ...
          problem.part(use);
  steep = max (abs (surrogateJacobian (surrogates, problem, p)), 1e-6);
  step = min (max (4 * min (noise' ./ steep, [], 1), 0.02), 0.2);
end

%!test
%! % rows beyond the targets are differentiated too; a failed run is not
%! [problem, state, s] = smallCalibration ();
%! problem.cost = @(p, f) [f(p) ./ [4; 2] - 1; p(2)];
%! problem.nExtra = 1;
%! law = @(P) [3 + P(:, 1) + P(:, 2) / 2, 1 + P(:, 1) + P(:, 2) / 2.5];
%! truth = [1, 1; 1, 0.8; 0, 2] ./ [4; 2; 1];
%! f = problem.cost ([0.5; 1], @(p) law (p')');
%! J = differencesOnDEM ([0.5, 1], f, law, 1:3, state, problem);
%! truth = [0.25, 0.25; 0.5, 0.4; 0, 2];
%! assert (J, truth, 1e-9);
%! failing = @(P) law (P) + 0 ./ (P(:, 1) == 0.5);
%! J = differencesOnDEM ([0.5, 1], f, failing, 1:3, state, problem);
%! assert (J(:, 2), truth(:, 2), 1e-9);
%! assert (J(:, 1), truth(:, 1), 0.05);
