% FINISHEDSETS  Number of sets that surrogates can learn of.
%
% CALL: N = finishedSets (DATA [, LIMITS])
%
%   DATA    see newData;  LIMITS  2 x d, the box that they lie in (anywhere)
%   N       scalar: sets with a finished run, for the target that has fewest.
%           Replicates are one set: they say nothing of what a parameter does

function n = finishedSets (data, limits)
  if nargin < 2
    limits = [-Inf; Inf];
  end
  n = Inf;
  for t = 1:columns (data.Z)
    X = insideLimits (data.X(isfinite (data.Z(:, t)), :), limits);
    n = min (n, rows (unique (X, 'rows')));
  end
end

%!test
%! data = addRows (newData (1, 2), [0.1; 0.1; 0.2; 0.3; 7], ...
%!                 [1, 1; 1, 1; 1, NaN; NaN, 1; 1, 1], (1:5)', 'import');
%! assert ([finishedSets(data, [0; 1]), finishedSets(data)], [2, 3]);
%!assert (finishedSets (newData (1, 2), [0; 1]), 0)

% SPDX-License-Identifier: GPL-3.0-only
