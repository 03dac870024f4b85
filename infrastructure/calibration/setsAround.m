% SETSAROUND  Sets around a set, within the box.
%
% CALL: P = setsAround (P, STEP, LIMITS)
%
% P       1 x d or n x d
% STEP    n x d, as parts of the box
% LIMITS  2 x d, the box
% P       n x d; what would lie outside lies on the limit

function P = setsAround (p, step, limits)
  P = p + step .* diff (limits);
  P = min (max (P, limits(1, :)), limits(2, :));
end

%!assert (setsAround ([1, 5], [0.1, 0.5; -0.2, 0.1], [0, 0; 10, 10]), ...
%!        [2, 10; 0, 6])
