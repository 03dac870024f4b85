% FADINGALONG  Correlation of errors that fade over a third of a curve.
%
% CALL: R = fadingAlong (PROBLEM, TARGETS)
%
%   PROBLEM  struct with series (1 x T, targets with one number > 0 belong to one
%            curve) and coordinate (1 x T, place on it), see newProblem
%   TARGETS  1 x n, numbers of targets (all)
%   R        n x n: 1 on the diagonal, 0 between different curves
%
% A third: an error of the model's form bends a curve, but does not wiggle with
% each of its points, which would count as as many independent errors.

function R = fadingAlong (problem, targets)
  if nargin < 2
    targets = 1:numel (problem.series);
  end
  series = problem.series(targets);
  coordinate = problem.coordinate(targets);
  R = diag (double (series == 0));
  for s = setdiff (series, 0)
    inSeries = series == s;
    x = coordinate(inSeries);
    length_ = (max (x) - min (x)) / 3;
    R(inSeries, inSeries) = exp (-abs (x' - x) / max (length_, realmin));
  end
end

%!test
%! problem = struct ('series', [0, 1, 1, 2], 'coordinate', [0, 0, 3, 3]);
%! R = [1, 0, 0, 0; 0, 1, exp(-3), 0; 0, exp(-3), 1, 0; 0, 0, 0, 1];
%! assert (fadingAlong (problem), R, eps);
%! assert (fadingAlong (problem, [1, 3]), eye (2));

% SPDX-License-Identifier: GPL-3.0-only
