% ASKEDRESULTS  Which results the runs of a set give, by the models that are run.
%
% CALL: YES = askedResults (BUDGET, BENCH)
%
%   BUDGET  see newEvaluate;  BENCH  1 x T, number of the model of each result
%   YES     1 x T logical

function yes = askedResults (budget, bench)
  yes = true (size (bench));
  if ~isscalar (budget.models)
    yes = budget.models(bench);
  end
end

%!assert (askedResults (struct ('models', [true, false]), [1, 2, 2]), [true, false, false])
%!assert (askedResults (struct ('models', true), [1, 2]), [true, true])

% SPDX-License-Identifier: GPL-3.0-only
