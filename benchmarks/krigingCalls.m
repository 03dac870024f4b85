% KRIGINGCALLS  Calls of stk and of an own likelihood in a default calibration.
%
% CALL: octave-cli benchmarks/krigingCalls.m STANDINS SEED [CSVFILE]
%
%   STANDINS  names of standIn, e.g. plain,rough,silo;  SEED  e.g. 1
%
% One CSV row a stand-in: standin, seed, runs, and the calls of each function, as
% Octave's profiler counts them. A calibration is that of calibrateStandIn.
%
% See also: calibrateStandIn, krigingTime

1;

function row = countCalls (name, seed, functions)
  profile ('on');
  r = calibrateStandIn (standIn (name, seed), seed, 0, struct ());
  profile ('off');
  table = profile ('info').FunctionTable;
  profile ('clear');
  row = [seed, r.runs];
  for f = functions
    row(end + 1) = sum ([table(strcmp ({table.FunctionName}, f{1})).NumCalls]);
  end
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
functions = {'stk_param_estim', 'stk_param_relik', 'quickCost', 'stk_predict', 'fitSurrogates'};
lines = {strjoin([{'standin', 'seed', 'runs'}, functions], ',')};
for name = strsplit (given{1}, ',')
  row = countCalls (name{1}, str2double (given{2}), functions);
  lines{end + 1} = [name{1}, sprintf(',%d', row)];
  printf ('%s\n', lines{end});
end
if numel (given) > 2
  writeTable (given{3}, lines);
end

% SPDX-License-Identifier: GPL-3.0-only
