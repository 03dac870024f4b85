% PAIRSTARTS  Where the fit of a pair of effects starts.
%
% CALL: U = pairStarts (P, A, B)
%
%   P     number of parameters
%   A, B  1 x (p + 2), normal coordinates of the fits of each effect alone:
%         parameters, strength, amplitude
%   U     3 x (p + 3): either effect with a little of the other, half of both
%
% See also: listHypotheses, runCures

function U = pairStarts (p, a, b)
  U = [a(1:p + 1), -0.5, 0; b(1:p), -0.5, b(p + 1), 0; ...
       (a(1:p) + b(1:p)) / 2, a(p + 1) - 0.3, b(p + 1) - 0.3, 0];
end

%!assert (pairStarts (1, [1, 2, 9], [3, 4, 9]), ...
%!        [1, 2, -0.5, 0; 3, -0.5, 4, 0; 2, 1.7, 3.7, 0], 1e-12)
