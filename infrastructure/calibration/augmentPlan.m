% AUGMENTPLAN  Further plan rows, as far as possible from the ones there are.
%
% CALL: P = augmentPlan (X, N, LIMITS)
%
% X       m x d  rows of the plan (m may be 0)
% N       number of rows to add
% LIMITS  2 x d  box
% P       n x d
%
% Greedy maximin in the unit box over a space-filling sample (the distance to
% the walls counts half a step, so rows do not crowd there).
%
% Errors: DEcalioc:augmentPlan:badShape
%
% See also: GenerateExperPlan, improveByInfill

function P = augmentPlan (X, n, limits)
  d = columns (limits);
  if columns (X) ~= d
    error ('DEcalioc:augmentPlan:badShape', ...
           'augmentPlan: X must be m x %d, got %d x %d.', d, size (X));
  end
  width = diff (limits);
  U = (X - limits(1, :)) ./ width;
  C = double (stk_sampling_halton_rr2 (2000, d, [zeros(1, d); ones(1, d)]));
  wall = 2 * min (min (C, 1 - C), [], 2);
  nearest = wall;
  for i = 1:rows (U)
    nearest = min (nearest, sqrt (sum ((C - U(i, :)).^2, 2)));
  end
  P = zeros (n, d);
  for k = 1:n
    [~, best] = max (nearest);
    P(k, :) = limits(1, :) + C(best, :) .* width;
    nearest = min (nearest, sqrt (sum ((C - C(best, :)).^2, 2)));
  end
end

%!test
%! % the gap is filled first
%! pkg load stk
%! X = [0.1; 0.2; 0.3; 0.9];
%! P = augmentPlan (X * 10, 1, [0; 10]);
%! assert (P, 6, 0.4);
%! assert (size (augmentPlan (zeros (0, 2), 3, [0, 0; 1, 1])), [3, 2]);

%!error id=DEcalioc:augmentPlan:badShape augmentPlan ([1, 2], 1, [0; 1]);
