% ODDSOFSHIFT  Odds that another source of runs is off, against chance.
%
% CALL: [ODDS, T, VALUES] = oddsOfShift (DATA, OTHER, PROBLEM)
%
%   DATA    see newData
%   OTHER   struct source (a stage of DATA), surrogates (of its runs alone)
%   ODDS    of a shift of the source, normal with a standard deviation of one
%           tolerance, or of the response itself (a table in another unit), against
%           none; of the result that shows it most, its number T
%   VALUES  struct of that result: name, runs (that were compared), predicted and got
%           (means over them)
%
% Compared are the runs of this case where the source knows the mean response as
% well as one run does. Of three and more the farthest is left out, as it may be
% wrong. No surrogate is believed to a fifth of a tolerance. Errors along a curve
% are alike: it counts by the median of its points.

function [odds, t, values] = oddsOfShift (data, other, problem)
  own = keepRows (runsThatCount (data, problem), ...
                  ~ismember (runsThatCount (data, problem).stage, {'import', 'library'}));
  [m, v] = predictSurrogate (other.surrogates, own.X);
  half = problem.tol .* abs (problem.scale);
  T = numel (half);
  [logOdds, n, predicted, got] = deal (-Inf (1, T), zeros (1, T), NaN (1, T), NaN (1, T));
  for k = find (isfinite (half) & half > 0)
    s = other.surrogates(k);
    isLike = isfinite (own.Z(:, k)) & ...
             sqrt (v(:, k)) <= max (sqrt (s.noiseVar), 0.2 * half(k));
    n(k) = sum (isLike);
    if n(k) > 0
      off = withoutFarthest ((own.Z(isLike, k) - m(isLike, k)) / half(k));
      known = mean (v(isLike, k)) + s.noiseVar / numel (off);
      predicted(k) = mean (m(isLike, k));
      got(k) = mean (own.Z(isLike, k));
      shifts = [1, abs(predicted(k)) / half(k)];
      logOdds(k) = max (logOddsOf (mean (off), max (sqrt (known) / half(k), 0.2), ...
                                   shifts, s.df));
    end
  end
  [groups, ~, isJoint] = requirementsOf (problem, 1:T);
  for group = groups(isJoint)
    logOdds(group{1}) = median (logOdds(group{1}));
  end
  [worst, t] = max (logOdds);
  odds = exp (worst);
  values = struct ('name', problem.targetNames{t}, 'runs', n(t), ...
                   'predicted', predicted(t), 'got', got(t));
end

function off = withoutFarthest (off)
  if numel (off) > 2
    [~, far] = max (abs (off));
    off(far) = [];
  end
end

% Student's densities of a mean that is off by X tolerances, where shifts of such size are.
function l = logOddsOf (x, sd, shifts, df)
  wide = hypot (sd, shifts);
  l = log (sd ./ wide) + ...
      (df + 1) / 2 * (log1p ((x / sd)^2 / df) - log1p ((x ./ wide).^2 / df));
end

%!test
%! % of one run: of normal densities by hand (many degrees of freedom)
%! problem = smallProblem (1, 0.1);
%! fit = @(x) fitSurrogate (x, ones (size (x)), [0; 1]);
%! x = linspace (0, 1, 12)';
%! other = struct ('source', 'import', 'surrogates', fit (x));
%! other.surrogates.df = 1e6;
%! data = addRows (newData (1, 1), [x; 0.5], [ones(12, 1); 1.15], ones (13, 1), 'import');
%! data.stage{13} = 'verify';
%! [odds, t, values] = oddsOfShift (data, other, problem);
%! d = @(x, s) exp (-(x / s)^2 / 2) / s;
%! assert (odds, d (1.5, hypot (1, 0.2)) / d (1.5, 0.2), -1e-3);
%! assert ({t, values.runs, values.got}, {1, 1, 1.15});
%! % in another unit, the noise of the source, too, is many tolerances
%! other.surrogates = setfield (fitSurrogate (x, 1e3 * ones (size (x)) + 20 * sin (40 * x), ...
%!                                            [0; 1]), 'df', 9);
%! assert (oddsOfShift (data, other, problem) > 1e3);
%! % nothing to compare: neither
%! assert (oddsOfShift (keepRows (data, 1:12), other, problem), 0);

% SPDX-License-Identifier: GPL-3.0-only
