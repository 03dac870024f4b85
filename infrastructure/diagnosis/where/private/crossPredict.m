% CROSSPREDICT  Calibrates on some targets and predicts others.
%
% CALL: CROSS = crossPredict (STUDY, FROM, TO)
%
%   STUDY       struct problem, emulator, hypotheses, see locateGap
%   FROM, TO    rows of target numbers
%   CROSS       struct
%     p           of the misfit of TO, r' [S + J C J']^-1 r (chi-square),
%                 against noise, surrogate and C, what FROM leaves open of
%                 the parameters
%     mean, sd    1 x numel (TO): prediction of the measurements TO, raw units

function cross = crossPredict (study, from, to)
  problem = study.problem;
  emulator = study.emulator;
  hypotheses = study.hypotheses;
  budget = noiseBudget (problem, emulator);
  null = newHypothesis ('null');
  white = whitenEmulator (emulator, from, budget);
  view = viewHypothesis (white, null, hypotheses.prior);
  starts = hypotheses.list(1).starts;
  Z = repmat (problem.value(from) * white.W', rows (starts), 1);
  fit = fitHypothesis (white, null, Z, starts, hypotheses.prior);
  [~, best] = max (fit.logPeak);
  A = reshape (fit.A(best, :, :), emulator.p, emulator.p);
  % the reference has told its part through FROM
  other = whitenEmulator (setfield (emulator, 'known', []), to, budget);
  view.white = other;
  [M, V, ~, J] = predictHypothesis (view, fit.U(best, :));
  J = reshape (vertcat (J{:})', numel (to), emulator.p);
  % what FROM leaves open of the parameters comes through the slopes
  S = diag (V) + J * (A \ J');
  r = problem.value(to) * other.W' - M;
  % the upper tail of chi-square
  cross.p = gammainc (r * (S \ r') / 2, numel (to) / 2, 'upper');
  back = other.back;
  cross.mean = M * back';
  cross.sd = sqrt (diag (back * S * back'))';
end

%!test
%! % no gap: predictions hold the values within their deviations (4 allowed)
%! rand ('twister', 2); randn ('twister', 2);
%! lab = standInGap (0);
%! given = lab.problem;
%! given.value = lab.means (0.4 * ones (1, 4), zeros (1, 10)) ...
%!           + sqrt (2) * lab.noiseSd .* randn (1, 24);
%! cross = crossPredict (labStudy (given, lab.plan (30, 2)), 1:18, 19:24);
%! assert (all (abs (cross.mean - given.value(19:24)) < 4 * cross.sd));
%! assert (cross.p > 0.001);

% SPDX-License-Identifier: GPL-3.0-only
