% SCOREMEASUREMENTS  Says what tests would tell, from a few runs of each.
%
% CALL: TESTS = scoreMeasurements (TESTS, CAUSES)
%
%   TESTS   1 x m struct, of which are read
%     Z       n x T, results of runs
%     group   n x 1, explanation that each run is of: 1 the null model, 2 to G
%             the others, one run at the mode of each, further ones at draws of
%             its posterior
%     noise   1 x T, scatter of one run, from other runs (standard deviation)
%     sd      1 x T, uncertainty of a reading
%     trials  scalar, of which the measurement would be the mean
%     doubt   1 x G, what the surrogates of the test, once it is measured, will
%             leave open of each explanation: variance over that of a reading of
%             all trials
%           and come back with gain (bits about the kind of cause), pair
%           (kinds that it tells apart most, see mixtureInformation) and promise
%           (the gain if the means of the runs were the true ones)
%   CAUSES  1 x h struct, the hypotheses: P (sum 1), group (explanation that its
%           mean comes from), kind (number), extent (root mean square of the
%           error of its form over its effect; 0: none)
%
% A run of another explanation lies where it differs by signature and refit.
% What scatter makes of a difference is taken out: the groups' means of target t
% are drawn together by 1 - (G - 1) / Q_t, Q_t their squared distances from the
% common mean in units of their errors, or by 1 - (G - 1) T / sum (Q), the
% smaller of the two, 0 at least (Stein 1956, empirical Bayes); what is left of
% an error stays in the prediction's variance. Scatter and spread over the
% posterior: that of the groups about their means, with a guess that counts as
% four runs: the scatter, and once more scatter and reading together, for a
% prediction is no surer than the measurements that it rests on. An effect does
% what its law says, and something of size extent along no known direction.
% Once the test is measured, surrogates stand where runs stand now: their doubt
% is added.

function tests = scoreMeasurements (tests, causes)
  for i = 1:numel (tests)
    groups = groupsOf (tests(i));
    [tests(i).gain, tests(i).pair] = gainOf (groups, causes);
    % differences as they stand: what more runs may still show
    groups.mean = groups.own;
    tests(i).promise = gainOf (groups, causes);
  end
end

function [gain, pair] = gainOf (groups, causes)
  parts = struct ('mean', {}, 'cov', {});
  for cause = causes
    parts(end + 1) = predictive (groups, cause);
  end
  [gain, pair] = mixtureInformation (parts, [causes.P], [causes.kind]);
end

function part = predictive (groups, cause)
  g = cause.group;
  part.mean = groups.mean(g, :);
  strange = 0;
  if cause.extent > 0
    added = (part.mean - groups.mean(1, :)) / chol (groups.cov);
    strange = cause.extent^2 * sum (added.^2) / numel (added);
  end
  part.cov = (1 + strange) * groups.cov + ...
             diag (groups.left(g, :) + groups.doubt(g) * groups.reading);
end

% Mean of each explanation, what is left open of it, and the covariance of a
% measurement about it.
function groups = groupsOf (test)
  G = max (test.group);
  n = accumarray (test.group, 1, [G, 1]);
  M = zeros (G, columns (test.Z));
  R = test.Z;
  for g = 1:G
    inGroup = test.group == g;
    M(g, :) = mean (test.Z(inGroup, :), 1);
    R(inGroup, :) = R(inGroup, :) - M(g, :);
  end
  [V, C] = spreadOf (R, rows (R) - G, test);
  % one run alone stands at the mode: it errs by its scatter
  E = V ./ n;
  E(n == 1, :) = repmat (test.noise.^2, sum (n == 1), 1);
  middle = sum (M ./ E, 1) ./ sum (1 ./ E, 1);
  Q = sum ((M - middle).^2 ./ E, 1);
  share = min (1 - (G - 1) ./ Q, 1 - (G - 1) * numel (Q) / sum (Q));
  share = max (share, 0);
  posterior = max (V - test.noise.^2, 0);
  reading = test.noise.^2 / test.trials + test.sd.^2;
  sd = sqrt (posterior + reading);
  groups = struct ('mean', middle + share .* (M - middle), 'own', M, ...
                   'left', share .* E, 'cov', (sd' * sd) .* C, ...
                   'doubt', test.doubt, 'reading', reading);
end

% Variance of one run of an explanation, and the correlation of its results.
function [V, C] = spreadOf (R, df, test)
  T = columns (R);
  % scatter, and once more scatter and reading: nothing is predicted better than
  % measured
  guess = 2 * test.noise.^2 + test.sd.^2;
  V = (4 * guess + sum (R.^2, 1)) / (4 + df);
  scale = sqrt (sum (R.^2, 1));
  S = (R' * R) ./ max (scale' * scale, realmin);
  share = df / (df + 2 * T);
  C = share * S;
  C(1:T + 1:end) = 1;
end

%!function causes = known ()
%!  causes = struct ('P', {0.2, 0.4, 0.4}, 'group', {1, 2, 3}, ...
%!                   'kind', {1, 2, 3}, 'extent', 0);
%!endfunction
%!function test = runsOf (M, noise, again)
%!  group = repmat ((1:rows (M))', 1 + again, 1);
%!  test = struct ('Z', M(group, :) + noise * randn (numel (group), ...
%!                                                   columns (M)), ...
%!                 'group', group, 'noise', noise * ones (1, columns (M)), ...
%!                 'sd', noise * ones (1, columns (M)), 'trials', 3, ...
%!                 'doubt', zeros (1, rows (M)));
%!endfunction
%!test
%! % far apart: the entropy of the kinds; which two, where the third is alike
%! randn ('twister', 1);
%! entropy = -sum ([0.2, 0.4, 0.4] .* log2 ([0.2, 0.4, 0.4]));
%! t = scoreMeasurements (runsOf ([0, 0; 60, 0; 0, 60], 1, 0), known ());
%! assert (t.gain, entropy, 0.01);
%! t = scoreMeasurements (runsOf ([0, 0; 0, 0; 0, 60], 1, 0), known ());
%! assert (t.pair, [2, 3]);
%! % surrogates that know nothing of the test would tell nothing by it
%! vague = runsOf ([0, 0; 60, 0; 0, 60], 1, 0);
%! vague.doubt(:) = 1e6;
%! assert (scoreMeasurements (vague, known ()).gain < 0.01);
%! % two of one kind: nothing to tell between them
%! causes = setfield (known (), {3}, 'kind', 2);
%! causes(3).group = 2;
%! causes(3).extent = 0.5;
%! t = scoreMeasurements (runsOf ([0, 0; 60, 0], 1, 0), causes);
%! assert (t.gain, -0.2 * log2 (0.2) - 0.8 * log2 (0.8), 0.01);
%!test
%! % scatter alone tells next to nothing: in the mean of 100 tests of 6 results
%! % (0.04 with four runs, less than 0.01 with sixteen)
%! randn ('twister', 2);
%! for again = [0, 3]
%!   gains = zeros (1, 100);
%!   for i = 1:100
%!     gains(i) = scoreMeasurements (runsOf (zeros (4, 6), 1, again), ...
%!       struct ('P', 0.25, 'group', {1, 2, 3, 4}, 'kind', {1, 2, 3, 4}, ...
%!               'extent', 0)).gain;
%!   end
%!   assert (mean (gains) < 0.1);
%! end
%!test
%! % what it says is what is there: the mean gain of 60 drawn tests against that
%! % of the true means, within a fifth
%! randn ('twister', 3);
%! [said, is] = deal (zeros (1, 60));
%! for i = 1:60
%!   M = 2 * randn (3, 4);
%!   % as much spread over the posterior as scatter
%!   test = runsOf (M, sqrt (2), 3);
%!   test.noise(:) = test.sd(:) = 1;
%!   said(i) = scoreMeasurements (test, known ()).gain;
%!   exact = struct ('mean', num2cell (M, 2)', 'cov', ...
%!                   (1 + 1 / 3 + 1) * eye (4));
%!   is(i) = mixtureInformation (exact, [0.2, 0.4, 0.4], 1:3);
%! end
%! assert (mean (said), mean (is), 0.2 * mean (is));
%! assert (corr (said', is') > 0.8);

% SPDX-License-Identifier: GPL-3.0-only
