% KRIGINGCALLS  Calls of stk and of an own likelihood in a default calibration.
%
% CALL: octave-cli benchmarks/krigingCalls.m STANDINS SEED [CSVFILE]
%
%   STANDINS  names of standIn, e.g. plain,rough,silo;  SEED  e.g. 1
%
% One CSV row a stand-in: standin, seed, runs, and of each function, as Octave's
% profiler counts: calls, seconds in it and what it calls, by the clock. A
% calibration is that of calibrateStandIn; the profiler takes a tenth more.
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
    known = strcmp ({table.FunctionName}, f{1});
    row = [row, sum([table(known).NumCalls]), ...
           sum([table(known).TotalTime, 0])];
  end
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
names = strsplit (given{1}, ',');
functions = {'stk_param_estim', 'stk_param_relik', 'quickCost', 'stk_predict', ...
             'fitSurrogates', 'calibrateStandIn'};
titles = cellfun (@(f) {[f, '_calls'], [f, '_seconds']}, functions, ...
                  'UniformOutput', false);
titles = ['standin', 'seed', 'runs', titles{:}];
lines = {strjoin(titles, ',')};
for name = names
  row = countCalls (name{1}, str2double (given{2}), functions);
  line = sprintf (',%.4g', row);
  printf ('%s%s\n', name{1}, line);
  lines{end + 1} = [name{1}, line];
end
if numel (given) > 2
  writeTable (given{3}, lines);
end
