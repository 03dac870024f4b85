% GENERATEEXPERPLAN  Draws a maximin Latin hypercube plan with stk.
%
% CALL: PLAN = GenerateExperPlan (FACTORLIMITS, N, PATHEXPLAN, SEED)
%
%   FACTORLIMITS  2 x d, lower and upper limit of each factor; a third row of
%                 ones where one is to be even in logarithms
%   N             number of samples; beyond 500 the best of fewer plans is
%                 taken, beyond 15,000 the first
%   PATHEXPLAN    folder in which ExperimentalPlan_DoE.csv is written, one row
%                 a sample, rounded as the runs are (toDigits); empty: no file
%   SEED          seed of the draw (default 1): same seed, same plan
%   PLAN          N x d
%
% The state of rand is put back, so the draw does not disturb the caller.
%
% Errors: DEcalioc:GenerateExperPlan:badShape
%
% See also: stk_sampling_maximinlhs, runPlan

function plan = GenerateExperPlan (factorLimits, N, pathExPlan, seed)
  if nargin < 4
    seed = 1;
  end
  if ~any (rows (factorLimits) == [2, 3])
    error ('DEcalioc:GenerateExperPlan:badShape', ...
           ['GenerateExperPlan: FACTORLIMITS must be 2 x d, ' ...
            'got %d x %d.'], size (factorLimits));
  end
  restore = seedRandom (seed);
  d = columns (factorLimits);
  plan = zeros (0, d);
  if N > 0
    box = [zeros(1, d); ones(1, d)];
    % a try compares all pairs of rows
    tries = min (1000, floor (2.5e8 / N^2));
    if tries > 0
      plan = stk_sampling_maximinlhs (N, d, box, tries);
    else
      plan = stk_sampling_randomlhs (N, d, box);
    end
    plan = fromUnit (double (plan), factorLimits);
  end
  if nargin > 2 && ~isempty (pathExPlan) && N > 0
    writeMatrix (fullfile (pathExPlan, 'ExperimentalPlan_DoE.csv'), ...
                 toDigits (plan));
  end
end

%!shared limits
%! limits = [500, 0.3; 800, 0.7];
%!test
%! plan = GenerateExperPlan (limits, 12, '', 3);
%! assert (size (plan), [12, 2]);
%! strata = floor (12 * (plan - limits(1, :)) ./ diff (limits));
%! assert (sort (strata), repmat ((0:11)', 1, 2));
%! assert (plan, GenerateExperPlan (limits, 12, '', 3));
%!assert (size (GenerateExperPlan (limits, 0)), [0, 2])
%!assert (size (GenerateExperPlan (limits, 1)), [1, 2])
%!test
%! rand ('twister', 5);
%! GenerateExperPlan (limits, 5);
%! a = rand ();
%! rand ('twister', 5);
%! assert (rand (), a);
%!error id=DEcalioc:GenerateExperPlan:badShape GenerateExperPlan ([1, 2], 5)

% SPDX-License-Identifier: GPL-3.0-only
