% FADINGALONG  Correlation of errors that fade over a third of a curve.
%
% CALL: R = fadingAlong (SERIES, COORDINATE)
%
%   SERIES      1 x T, targets with one number > 0 belong to one curve
%   COORDINATE  1 x T, place on it
%   R           T x T: 1 on the diagonal, 0 between different curves
%
% A third: an error of the model's form bends a curve, but does not wiggle with
% each of its points, which would count as as many independent errors.

function R = fadingAlong (series, coordinate)
  R = diag (double (series == 0));
  for s = setdiff (series, 0)
    inSeries = series == s;
    x = coordinate(inSeries);
    length_ = (max (x) - min (x)) / 3;
    R(inSeries, inSeries) = exp (-abs (x' - x) / max (length_, realmin));
  end
end

%!assert (fadingAlong ([0, 1, 1, 2], [0, 0, 3, 3]), ...
%!        [1, 0, 0, 0; 0, 1, exp(-3), 0; 0, exp(-3), 1, 0; 0, 0, 0, 1], eps)
