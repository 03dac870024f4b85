% FITWITHOUT  What the fits to all runs but some say of the runs.
%
% CALL: JUDGED = fitWithout (TASK, OUT)
%
%   TASK    scalar struct, the runs of one model: X (n x d), Z (n x T, NaN:
%           none), extra (n x 1 or [], a further input), surrogates (1 x T, of
%           fitSurrogate: trend and covariance are theirs), least (1 x T: a
%           smaller deviation is none)
%   OUT     n x 1 logical, runs that are left out
%   JUDGED  scalar struct: out; gain 1 x T, the log density of all runs, the
%           good ones by the surrogates, the others anywhere within 6 standard
%           deviations of the good ones; far n x 1 (how far a good run lies
%           from what the others foretell, in its deviations; 0: OUT), residual
%           (a row for each of ~OUT) x T, noiseSd 1 x T
%
% The scatter of a run is taken for no less than what two deviations of its
% prior leave (noisePrior, from stored runs): few runs on a curve that waves
% look free of noise.

function judged = fitWithout (task, out)
  n = rows (task.X);
  judged = struct ('out', out, 'gain', [], 'far', zeros (n, 1), ...
                   'residual', NaN (n, columns (task.Z)), 'noiseSd', []);
  for t = 1:columns (task.Z)
    old = task.surrogates(t);
    z = task.Z(:, t);
    isKnown = isfinite (z);
    use = isKnown & ~out;
    s = fitRows (task.X, z, task.extra, use, old.limits, ...
                 struct ('trend', old.trend, 'quick', old.quick, ...
                         'guess', old.theta, ...
                         'covariance', old.covariance));
    s = leastNoise (s);
    [unit, y] = deal (s.solver.unit, s.solver.y);
    of = setfield (s, 'noise', []);
    model = krigingModel (s.trend, s.covariance, columns (unit), of);
    nBeyond = numel (y) - numel (s.solver.beta);
    judged.gain(t) = -fitCost (model, unit, y, s.theta) - ...
                     nBeyond * log (s.scale) - ...
                     sum (out & isKnown) * log (6 * std (z(use)));
    judged.residual(use, t) = s.looResidual;
    judged.noiseSd(t) = sqrt (s.noiseVar);
    far = abs (s.looStd) .* (abs (s.looResidual) > task.least(t));
    judged.far(use) = max (judged.far(use), far);
  end
  judged.residual = judged.residual(~out, :);
end

function s = leastNoise (s)
  least = 2 * (log (0.3) - 1.6);
  if isempty (s.noiseLaw) && isscalar (s.model.lognoisevariance) && ...
     s.model.lognoisevariance < least && ~isConstant (s.z)
    choice = mergeFields (s, s.model);
    choice.lognoisevariance = least;
    s = conditionSurrogate (choice, s);
  end
end

%!test
%! rand ('twister', 4);
%! X = rand (9, 1);
%! z = 2 + X;
%! z(5) = 9;
%! s = fitSurrogate (X, z, [0; 1], struct ('trend', 'affine'));
%! task = struct ('X', X, 'Z', z, 'extra', [], 'surrogates', s, 'least', 0);
%! with = fitWithout (task, false (9, 1));
%! without = fitWithout (task, (1:9)' == 5);
%! [~, worst] = max (with.far);
%! assert ([worst, without.far(5), rows(without.residual)], [5, 0, 8]);
%! assert (without.gain > with.gain + 4);
%! assert (without.noiseSd, 0.3 * exp (-1.6) * std (z(1:9 != 5)), 1e-6);

% SPDX-License-Identifier: GPL-3.0-only
