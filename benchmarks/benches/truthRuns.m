% TRUTHRUNS  Runs a bench as the laboratory would, with packings of its own.
%
% CALL: Y = truthRuns (MODEL, VALUES, N, STEM)
%
%   MODEL   text, folder of the bench
%   VALUES  scalar struct of what the material is: those that its data.head
%           declares are set
%   N       number of trials, at most 4; their packings are seeds 5 to 8 of
%           benchSeeds, which no case draws
%   STEM    text, path of the runs; finished ones are reused
%   Y       N x m, see the bench's results.csv
%
% See also: benchRun, wholeRuns

function Y = truthRuns (model, values, n, stem)
  known = fieldnames (headDefaults (fullfile (model, 'data.head')));
  values = rmfield (values, setdiff (fieldnames (values), known));
  Y = [];
  for trial = 1:n
    values.runSeed = benchSeeds (4 + trial);
    Y = [Y; benchRun(sprintf ('%s-%d', stem, trial), model, values)];
  end
end

% SPDX-License-Identifier: GPL-3.0-only
