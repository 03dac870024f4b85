% STRONGFIRST  Orders effects: those that can be seen well enough come first.
%
% CALL: ORDER = strongFirst (ORDER, LAB, SPACE, THETA, LEVEL)
%
%   ORDER  1 x K, numbers of the effects; kept among equals
%   LAB    of foreignLab;  SPACE  of twinsSpace at THETA (1 x p, in [0, 1])
%   LEVEL  scalar, signal to noise that full strength has to reach
%
% See also: planStudy

function order = strongFirst (order, lab, space, theta, level)
  K = numel (order);
  reach = space.visible (lab.means (ones (K, 1) * theta, eye (K)) - ...
                         space.base)';
  order = [order(reach(order) >= level), order(reach(order) < level)];
end

%!test
%! lab.means = @(theta, phi) phi * [3; 1; 2; 5];
%! space = struct ('base', 0, 'visible', @(shape) abs (shape));
%! assert (strongFirst ([3, 2, 4, 1], lab, space, 0.5, 3), [4, 1, 3, 2]);
