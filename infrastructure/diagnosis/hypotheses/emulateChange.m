% EMULATECHANGE  Turns an emulator into that of a change from a reference.
%
% CALL: EMULATOR = emulateChange (EMULATOR, PROBLEM)
% CALL: EMULATOR = emulateChange (EMULATOR)        the one of the simulation again
%
%   EMULATOR    struct of fitEmulator, or what this has made of it
%   PROBLEM     struct of newProblem; without reference EMULATOR stays as it is
%   EMULATOR    coef then foretells what is measured in the other condition
%               where nothing has changed; surrogateVar and fitVar are nearly 0,
%               as what surrogates miss is the same in both; and
%     change    struct coef (q x T: what was added to the simulation),
%               covariance (T x T, of the measurements less what is foretold),
%               doubt (2 x T, see noiseBudget: of that covariance),
%               fresh, before (T x T, of a new reading, and of one of the reference)
%               simulated, missSd (1 x T, what the model gives at the reference, and
%               the noise of what is measured there less that)
%               lack (1 x T, what the model is likely to miss in both), size
%               (of that, root mean square, as a share of the range), plain
%               (coef, surrogateVar, fitVar as they were)
%     known     struct root (m x p), offset (m x 1): what the reference says of
%               the parameters, root theta - offset ~ N (0, I)
%
% With reference r and new measurements y, parameters theta, strengths phi,
%   r = m (theta, 0) + delta + b + e,  y = m (theta, phi) + delta + b + e',
% delta ~ N (0, s^2 C) what the model lacks, b the error of the surrogates, both
% alike in the two conditions. Given r, theta and s,
%   y ~ N (m (theta, phi) + K (r - m (theta, 0)), E' + D - K (D + X)'),
% D = s^2 C + B, K = (D + X) (D + E)^-1, with E, E', B the covariances of e, e', b
% and X that of e' with e: what was measured on the same days errs alike.
% The size s is integrated: on a grid, by its prior (a misfit of 0.08 of the
% range, a factor of e) and the evidence of r; mean and covariance are those of
% the mixture. C: independent errors in units of the ranges, along a curve alike
% over a third of it. A lack that is an error of scale grows with what changes;
% that is an error of the form of its cause (formError), and nothing here is
% taken from the change. After Kennedy and O'Hagan (2001), for two conditions
% instead of one.
%
% Parameters of PROBLEM.reference.perCondition are other ones in the two.

function emulator = emulateChange (emulator, problem)
  emulator = simulationOf (emulator);
  if nargin < 2 || isempty (problem.reference)
    return
  end
  reference = problem.reference;
  after = noiseBudget (problem, emulator);
  before = noiseBudget (ofReference (problem), emulator);
  at = find (isfinite (reference.value) & ~problem.aside);
  % a factor of 16 either way of what is usual: the evidence of the reference picks
  sizes = 0.08 * 2.^(-4:0.75:4);
  parts = cell (1, numel (sizes));
  score = zeros (1, numel (sizes));
  C = lackShape (emulator, problem);
  B = sharedError (emulator);
  X = reference.together';
  for i = 1:numel (sizes)
    lack = sizes(i)^2 * C;
    parts{i} = fitReference (emulator, problem, before, lack, at);
    score(i) = parts{i}.logE - 0.5 * log (sizes(i) / 0.08)^2;
    D = lack + B;
    both = D + X;
    parts{i}.K = both(:, at) / (D(at, at) + before.covariance(at, at));
    parts{i}.left = D - parts{i}.K * both(:, at)';
    parts{i}.lackOf = lack(:, at) / (D(at, at) + before.covariance(at, at));
  end
  weight = exp (score - max (score));
  weight = weight / sum (weight);
  calibrated = calibratedMeans (emulator, problem, before, at);
  emulator = mixed (emulator, problem, after, [parts{:}], weight, at);
  emulator.change.doubt = doubtOf (problem, after.own, before.own, ...
                                   emulator.change.K);
  [emulator.change.fresh, emulator.change.before] = deal (after.covariance, ...
                                                          before.covariance);
  emulator.change.size = sqrt (weight * (sizes.^2)');
  emulator.change.simulated = calibrated;
  emulator.change.missSd = sqrt (diag (before.covariance) + diag (B))';
end

function emulator = simulationOf (emulator)
  if ~isempty (emulator.change)
    for name = fieldnames (emulator.change.plain)'
      emulator.(name{1}) = emulator.change.plain.(name{1});
    end
  end
  [emulator.change, emulator.known] = deal ([]);
end

function problem = ofReference (problem)
  reference = problem.reference;
  if ~isempty (problem.covariance)
    % readings of one rig are correlated alike in both conditions, whatever their
    % sd; what sessions share is another
    isSame = problem.series' == problem.series & problem.series > 0;
    rest = problem.covariance - (problem.shared' * problem.shared) .* isSame;
    own = max (reference.sd.^2 - reference.shared.^2 .* any (isSame), 0);
    ratio = sqrt (own ./ diag (rest)');
    ratio(~isfinite (ratio)) = 0;
    problem.covariance = (ratio' * ratio) .* rest + ...
                         (reference.shared' * reference.shared) .* isSame;
  end
  for name = {'value', 'sd', 'trials', 'scatter', 'shared', 'freedom', ...
              'commonFreedom', 'sessionFreedom'}
    problem.(name{1}) = reference.(name{1});
  end
end

% What few trials leave in doubt of Y - K R. The scatter of a trial is one for
% both, and so is that of sessions: what their variances err adds up.
function doubt = doubtOf (problem, after, before, K)
  reference = problem.reference;
  before(~isfinite (reference.value)) = 0;
  before = before * (K.^2)';
  sessions = problem.shared.^2 + reference.shared.^2 * (K.^2)' - ...
             2 * diag (K)' .* diag (reference.together)';
  sessions = max (sessions, 0);
  common = after ./ sqrt (problem.commonFreedom) + ...
           before ./ sqrt (reference.commonFreedom);
  own = (after + before + sessions).^2 ./ min (problem.freedom, ...
                                               reference.freedom);
  common = common.^2 + sessions.^2 ./ min (problem.sessionFreedom, ...
                                           reference.sessionFreedom);
  doubt = [own; common];
end

function C = lackShape (emulator, problem)
  alike = fadingAlong (problem);
  % a fifth of it is each target's own: neighbours are not wrong by exactly the same
  C = 0.8 * alike + 0.2 * eye (columns (alike));
  C = C .* (emulator.range' * emulator.range);
end

% Error of the surrogates of the simulation itself.
function B = sharedError (emulator)
  D = sqrt (mean (emulator.surrogateVar, 1));
  misfit = sqrt (emulator.fitVar);
  B = (D' * D) .* emulator.correlation + (misfit' * misfit) .* emulator.misfitLikeness;
end

% Parameters by the reference alone, for one size of the lack: Q, logE, and
% information A, g of linear equations A theta = g. The scatter counts as known: that
% all trials scatter ten times as much as they show would else be believed before
% that the simulation lacks something, and what it lacks taken for a change. Too
% large a lack only makes a change the difference of two measurements.
function part = fitReference (emulator, problem, before, lack, at)
  before.doubt(:) = 0;
  before.covariance = before.covariance + lack;
  white = whitenEmulator (withoutEffects (emulator), at, before);
  fit = fitStarts (white, problem, at, problem.paramPrior);
  [part.logE, best] = max (fit.logE);
  % whitened by another W for each size: as a density of the targets they compare
  part.logE = part.logE + sum (log (svd (white.W)));
  part.Q = fit.Q(best, :);
  [M, V, ~, J] = predictGap (white, [], part.Q);
  J = reshape (vertcat (J{:})', numel (at), emulator.p) ./ sqrt (V');
  r = ((problem.reference.value(at) * white.W' - M) ./ sqrt (V))';
  part.A = J' * J;
  part.g = part.A * part.Q' + J' * r;
end

% From several starts: FIT of fitHypothesis, a row each.
function fit = fitStarts (white, problem, at, prior)
  starts = [zeros(1, white.p); 0.9 * boxPoints(white.p, 5)];
  null = newHypothesis ('null');
  unknowns = viewHypothesis (white, null, prior).unknowns;
  Z = repmat (problem.reference.value(at) * white.W', rows (starts), 1);
  fit = fitHypothesis (white, null, Z, toNormal (unknowns, starts), prior);
end

% What the set of a calibration gives: misses count in tolerances, and no prior draws it
% to the middle of the box.
function M = calibratedMeans (emulator, problem, before, at)
  before.covariance = before.covariance + diag ((problem.tol .* problem.scale).^2);
  flat = setfield (problem.paramPrior, 'flat', true);
  white = whitenEmulator (withoutEffects (emulator), at, before);
  fit = fitStarts (white, problem, at, flat);
  [~, best] = max (fit.logPeak);
  M = polyRows (emulator.powers, fit.Q(best, :)) * emulator.coef;
end

% The mixture over the sizes.
function emulator = mixed (emulator, problem, after, parts, weight, at)
  reference = problem.reference;
  [~, best] = max (weight);
  theta = parts(best).Q;
  same = ~reference.perCondition;
  % parameters that the reference has for itself stay where it has them
  points = emulator.points;
  points(:, ~same) = repmat (theta(~same), rows (points), 1);
  coef = polyRows (emulator.powers, emulator.points) \ ...
         (polyRows (emulator.powers, points) * emulator.coef);
  M = polyRows (emulator.powers, theta) * emulator.coef;
  r = reference.value(at) - M(at);
  [K, left, A, g, lack] = deal (0);
  for i = 1:numel (parts)
    K = K + weight(i) * parts(i).K;
    left = left + weight(i) * parts(i).left;
    A = A + weight(i) * parts(i).A;
    g = g + weight(i) * parts(i).g;
    lack = lack + weight(i) * (parts(i).lackOf * r')';
  end
  for i = 1:numel (parts)
    % law of total variance: what the sizes foretell differently is uncertain, too
    off = (parts(i).K - K) * r';
    left = left + weight(i) * (off * off');
  end
  emulator.change.plain = struct ('coef', emulator.coef, 'surrogateVar', ...
                                  emulator.surrogateVar, 'fitVar', emulator.fitVar);
  emulator.change.K = zeros (numel (reference.value));
  emulator.change.K(:, at) = K;
  emulator.change.coef = -coef(:, at) * K';
  isConstant = ~any (emulator.powers, 2);
  emulator.change.coef(isConstant, :) = emulator.change.coef(isConstant, :) + ...
                                  reference.value(at) * K';
  emulator.change.lack = lack;
  emulator.change.covariance = after.covariance + left;
  emulator.coef = emulator.coef + emulator.change.coef;
  % it stands in the covariance of the change now, and would count twice
  emulator.surrogateVar = repmat ((1e-6 * emulator.range).^2, rows (emulator.points), 1);
  emulator.fitVar = zeros (size (emulator.fitVar));
  emulator.known = knownOf (A, g, same);
end

% What is known of the parameters that both conditions share, whatever the
% others are.
function known = knownOf (A, g, same)
  p = rows (A);
  if ~all (same)
    % parameters of one condition alone are integrated out (Schur complement)
    gain = A(same, ~same) / (A(~same, ~same) + 1e-9 * eye (sum (~same)));
    g = g(same) - gain * g(~same);
    A = A(same, same) - gain * A(~same, same);
  else
    g = g(same);
  end
  [U, L] = eig ((A + A') / 2);
  L = diag (L);
  % directions of which the reference says nothing would divide by rounding
  kept = L > 1e-6 * max ([L; realmin]);
  known.root = zeros (sum (kept), p);
  known.root(:, same) = sqrt (L(kept)) .* U(:, kept)';
  known.offset = (U(:, kept)' * g) ./ sqrt (L(kept));
end

%!shared emulator, given
%! emulator = handMadeEmulator ([0, 0, 0, 0; 3, 1, 0, 0]);
%! emulator.range = 10 * ones (1, 4);
%! emulator.noiseVar(:) = 1e-6;
%! given = newProblem (struct ('value', zeros (1, 4), 'sd', ones (1, 4), ...
%!                                'limits', [0; 1], 'bench', ones (1, 4)));
%! given.reference = struct ('value', [1.5, 0.5, 5, -4], 'sd', ones (1, 4));
%! given = newProblem (given);
%!test
%! % a large lack is carried over whole: the difference is what counts
%! new = emulateChange (emulator, given);
%! told = predictGap (new, [], 0.5);
%! assert (told, given.reference.value, 1);
%! assert (abs (new.change.lack(3:4) - [5, -4]) < 1);
%! assert (diag (new.change.covariance)'(3:4) > 1.5);
%! % the change under test tells nothing of how sure it is
%! other = emulateChange (emulator, setfield (given, 'value', 100 * ones (1, 4)));
%! assert (other.change.covariance, new.change.covariance);
%! plain = emulateChange (new);
%! assert ({plain.coef, plain.known, plain.change}, {emulator.coef, [], []});
%! assert (emulateChange (plain), plain);
%!test
%! % what the simulation misses is no scatter that few trials did not show: the
%! % reference is believed as if its scatter were known
%! few = given;
%! few.reference.value = [9.5, -7.5, 5, -4];
%! [few.sd, few.reference.sd] = deal (0.5 * ones (1, 4));
%! known = emulateChange (emulator, few).change.size;
%! for name = {'freedom', 'commonFreedom'}
%!   [few.(name{1}), few.reference.(name{1})] = deal (5 * ones (1, 4));
%! end
%! assert (emulateChange (emulator, few).change.size, known, 1e-9);
%!test
%! % no lack: the model is believed, and the reference tells the parameter
%! given.reference.value = [1.5, 0.5, 0, 0];
%! given.reference.sd(:) = 0.01;
%! given.sd(:) = 0.01;
%! new = emulateChange (emulator, given);
%! assert (predictGap (new, [], 0.5), given.reference.value, 0.01);
%! assert (new.known.root \ new.known.offset, 0.5, 0.02);
%!test
%! % read on the same days: what they share is no part of the change
%! given.reference.value = [1.5, 0.5, 5, -4];
%! [given.sd, given.reference.sd] = deal (ones (1, 4));
%! apart = emulateChange (emulator, given).change;
%! [given.shared, given.reference.shared] = deal (0.8 * ones (1, 4));
%! [given.sessionFreedom, given.reference.sessionFreedom] = deal (2 * ones (1, 4));
%! given.reference.together = 0.64 * eye (4);
%! paired = emulateChange (emulator, given).change;
%! assert (diag (apart.covariance)(3:4) > 1.4);
%! assert (diag (paired.covariance)(3:4), 0.72 * [1; 1], 0.1);
%! assert (apart.doubt, zeros (2, 4));
%! assert (all (paired.doubt(:) < 0.1));
%! given.reference.together = zeros (4);
%! assert (all (emulateChange (emulator, given).change.doubt(2, 3:4) > 0.4));
%!test
%! % another parameter in each condition: the reference tells nothing of it
%! given.reference.perCondition = true;
%! new = emulateChange (emulator, given);
%! assert (isempty (new.known.root));
%! assert (polyval (polyfit ([-1, 0, 1], predictGap (new, [], ...
%!                  [-1; 0; 1])(:, 1)', 1), 1) > 1);

%!test
%! % 150 targets known to a thousandth of their range: no determinant is left,
%! % but its logarithm (seeded; 0.3 of the range was drawn)
%! emulator = handMadeEmulator ([zeros(1, 150); 3 * (1:150) / 150]);
%! emulator.range = 1000 * ones (1, 150);
%! emulator.noiseVar(:) = 1e-6;
%! given = newProblem (struct ('value', zeros (1, 150), 'sd', ...
%!                                ones (1, 150), 'limits', [0; 1], 'bench', ...
%!                                ones (1, 150)));
%! randn ('twister', 1);
%! given.reference = struct ('value', 300 * randn (1, 150), 'sd', ones (1, 150));
%! given = newProblem (given);
%! assert (emulateChange (emulator, given).change.size, 0.3, 0.06);

% SPDX-License-Identifier: GPL-3.0-only
