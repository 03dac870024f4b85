% LOOKALIKEEXTENT  The look-alike that a name must be told from.
%
% CALL: EXTENT = lookAlikeExtent ()
%
%   EXTENT  1 x 2, of newHypothesis: the angle of a signature whose cosine with
%           the named one is 0.9, fixed
%
% At 0.9 the unknown part is nearly half as long as the known one: a cause that
% differs less is, for calibration, that cause.
%
% See also: newHypothesis, weighCase

function extent = lookAlikeExtent ()
  extent = [tan(acos (0.9)), 1e-6];
end

%!assert (lookAlikeExtent ()(1), 0.4843, 1e-4)
