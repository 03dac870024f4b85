% KNOWNPARAMETERS  Intervals of the parameters, held against the set and runs.
%
% CALL: KNOWN = knownParameters (STATE, PROBLEM)
%
%   KNOWN  struct of parameterPosterior and
%          identified  1 x d logical: the interval is narrower than
%                  options.loose of the box
%          fits    share of the sample that fits (below)
%          code    '' where interval90 may be used; 'no fit': fewer than
%                  options.fit of the sample fit, interval90 is NaN and nothing
%                  is identified; 'few runs' (of a curve), 'unseen' (noise that
%                  nobody has seen), 'compromise' (the set misses a target and
%                  lies outside): note says what the interval is then
%          note    text that goes on after 'the intervals are ', '': none
%
% A set of the sample fits where its expected response is within the tolerance
% of each target, or within 2.5 standard deviations of what a measured value is
% off by (errorVariance; along a curve the root mean square of the misses over these),
% to which at most four times its variance is added where
% the surrogate is not sure: a set that only such doubt keeps is none that fits.
% On decades in logarithms and as they are the shares are 0.84 to 0.89 and below
% 0.8, and the intervals of the latter are wrong (benchmarks/bends.m). Near a run,
% what this run gave beyond what the surrogate says there is added to what the
% surrogate says of the set.
%
% Where the reported set itself fits, interval90 is wide enough to hold it: it
% is one of the sets of which the interval speaks.

function known = knownParameters (state, problem)
  known = parameterPosterior (state.surrogates, problem);
  p = state.found.params;
  [allowed, unseen] = allowedMiss (state.surrogates, problem);
  known.fits = mean (doesFit (known.sample, state, problem, allowed));
  [known.code, known.note] = deal ('');
  isOutside = p < known.interval90(1, :) | p > known.interval90(2, :);
  [code, note] = jointNote (state.data, problem);
  if known.fits < problem.options.fit
    known.interval90(:) = NaN;
    [known.code, known.note] = deal ('no fit', noFit (known.fits));
  elseif ~isempty (note)
    [known.code, known.note] = deal (code, note);
  elseif any (unseen)
    [known.code, known.note] = deal ('unseen', unseenNote (problem, unseen));
  end
  if any (isOutside) && ~strcmp (known.code, 'no fit')
    known = withSet (known, p, state, problem, allowed);
  end
  width = diff (toUnit (known.interval90, problem.limits));
  known.identified = ~(width >= problem.options.loose);
end

function known = withSet (known, p, state, problem, allowed)
  if doesFit (p, state, problem, allowed)
    known.interval90 = [min(known.interval90(1, :), p); ...
                        max(known.interval90(2, :), p)];
  elseif isempty (known.code)
    known.code = 'compromise';
    known.note = ['those of the likeliest parameter values, each result weighted by ' ...
                  'its noise; a value outside misses a target, but by less than others'];
  end
end

% How far a response may be off, 1 x T tol and variance (Inf: any), and of which
% targets no noise was seen.
function [allowed, unseen] = allowedMiss (surrogates, problem)
  T = numel (surrogates);
  [allowed.tol, allowed.variance, unseen] = deal (Inf (1, T), Inf (1, T), ...
                                                  false (1, T));
  [groups, ~, isJoint] = requirementsOf (problem);
  for t = [groups{:}]
    [allowed.variance(t), unseen(t)] = errorVariance (surrogates(t).noiseVar, ...
                                                      problem, t);
    allowed.tol(t) = problem.tol(t) * abs (problem.scale(t));
  end
  unseen([groups{isJoint}]) = false;         % the size of their errors is estimated
end

function yes = doesFit (P, state, problem, allowed)
  [m, v] = predictSurrogate (state.surrogates, P);
  miss = m + nearestMiss (P, state, problem) - problem.value;
  noise = allowed.variance;
  most = max (allowed.tol, 2.5 * sqrt (noise + min (v, 4 * noise)));
  yes = true (rows (P), 1);
  for group = requirementsOf (problem)       % a curve: root mean square of its points
    share = abs (miss(:, group{1})) ./ most(:, group{1});
    yes = yes & mean (share.^2, 2) <= 1;
  end
end

% What the runs nearest to each set gave beyond the surrogate there, less what
% a run scatters by; 0 where no run is within a tenth of the box.
function off = nearestMiss (P, state, problem)
  data = runsThatCount (state.data, problem);
  [sets, ~, set] = unique (data.X, 'rows');
  U = toUnit (P, problem.limits);
  V = toUnit (sets, problem.limits);
  off = zeros (rows (P), numel (problem.value));
  near = zeros (rows (P), rows (sets));
  for i = 1:rows (sets)
    near(:, i) = max (abs (U - V(i, :)), [], 2);
  end
  [least, i] = min (near, [], 2);
  m = predictSurrogate (state.surrogates, sets);
  for t = find (problem.calibrate)
    isKnown = isfinite (data.Z(:, t));
    n = accumarray (set(isKnown), 1, [rows(sets), 1]);
    z = accumarray (set(isKnown), data.Z(isKnown, t), [rows(sets), 1]);
    beyond = z ./ max (n, 1) - m(:, t);
    scatter = 3 * sqrt (state.surrogates(t).noiseVar ./ max (n, 1));
    beyond = sign (beyond) .* max (abs (beyond) - scatter, 0) .* (n > 0);
    off(:, t) = beyond(i) .* (least < 0.1);
  end
end

function text = noFit (share)
  amount = sprintf ('only %.0f %%', 100 * share);
  if share < 0.005
    amount = 'less than 1 %';
  end
  text = sprintf (['not printed: %s of the likeliest parameter values would ' ...
                   'meet the targets'], amount);
end

function text = unseenNote (problem, unseen)
  text = sprintf (['valid for measured values that are good to a tenth of their ' ...
                   'tolerance: runs scatter by less, and no uncertainty is given ' ...
                   '(%s; sd of measured.csv, or optim.targetStd)'], ...
                  strjoin (problem.targetNames(unseen), ', '));
end

% Why intervals of the parameters should not be used as such; '': they may be.
function [code, text] = jointNote (data, problem)
  [code, text] = deal ('');
  wanted = problem.options.intervalRuns;
  enough = problem.options.jointRuns * columns (problem.limits);
  [~, ~, isJoint] = requirementsOf (problem);
  if any (isJoint) && ...
     sum (strcmp (data.stage, 'interval')) < wanted && rows (data.X) < enough
    code = 'few runs';
    text = sprintf (['not to be used as intervals: %d runs are too few for ' ...
                     'a curve. Input.intervals = true makes %d more, or ' ...
                     'have %d runs in all'], rows (data.X), wanted, enough);
  end
end

%!test
%! [problem, state, s] = smallCalibration ();
%! state.found.params = mean (parameterPosterior (s, problem).sample);
%! known = knownParameters (state, problem);
%! assert (known.fits > 0.9);
%! assert (known.code, '');
%! assert (known.identified, diff (known.interval90) ./ [1, 2] < 0.5);
%! % a set that fits is in its own interval
%! [~, order] = sort (known.sample(:, 2));
%! state.found.params = known.sample(order(965), :);
%! known = knownParameters (state, problem);
%! assert (known.interval90(2, 2), state.found.params(2));
%! % one that does not is no part of it, and that is said
%! state.found.params = [1, 2];
%! known = knownParameters (state, problem);
%! assert (known.code, 'compromise');
%! assert (known.interval90(2, 2) < 2);
%!test
%! % runs near the sets of the sample contradict the surrogate
%! [problem, state] = smallCalibration ();
%! P = knownParameters (state, problem).sample(1:20:end, :);
%! Z = predictSurrogate (state.surrogates, P) + [1, 0];
%! state.data = addRows (state.data, P, Z, ones (rows (P), 1), 'infill');
%! known = knownParameters (state, problem);
%! assert (known.code, 'no fit');
%! assert (all (isnan (known.interval90(:))));
%! assert (all (known.identified));
%! assert (strncmp (known.note, 'not printed: ', 13));
%!test
%! % no noise, and none given: a quarter of the tolerance
%! [problem, state, ~, f] = smallCalibration ();
%! state.data.Z = f (state.data.X);
%! state.surrogates = fitSurrogates (state.data, problem);
%! known = knownParameters (state, problem);
%! assert (known.code, 'unseen');
%! problem.statedSd = 0.3 * problem.tol .* problem.value;
%! assert (! strcmp (knownParameters (state, problem).code, 'unseen'));

% SPDX-License-Identifier: GPL-3.0-only
