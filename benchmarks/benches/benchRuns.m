% BENCHRUNS  Runs a bench with the first packings of the bench programs.
%
% CALL: [RESULTS, FOLDERS, SECONDS] = benchRuns (STEM, BENCH, VARIABLES, N)
%
% STEM       text, path of the runs up to their seeds: <work>/<bench>--0 for
%            runs without effects, which all programs share; finished runs are
%            reused
% BENCH      text, name of a bench
% VARIABLES  scalar struct, see benchRun
% N          number of packings, at most 8
% RESULTS    N x m
% FOLDERS    1 x N cell of text
% SECONDS    1 x N, CPU time of each run (s)
%
% See also: benchRun, benchSeeds

function [results, folders, seconds] = benchRuns (stem, bench, variables, n)
  [results, seconds] = deal ([]);
  folders = {};
  for seed = benchSeeds (1:n)
    variables.runSeed = seed;
    folder = sprintf ('%s-%d', stem, seed);
    [row, seconds(end + 1)] = benchRun (folder, bench, variables);
    results = [results; row];
    folders{end + 1} = folder;
  end
end

% SPDX-License-Identifier: GPL-3.0-only
