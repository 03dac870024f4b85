% VISIBLECHANGE  How large a change of a reading must be to be seen.
%
% CALL: octave-cli benchmarks/visibleChange.m CSV
%
%   CSV  table that is written, a row for each way to measure: readings (how many the
%        rig has), trials (a day), days, paired (1: both states on the same days),
%        named (1: the days have names), seen (change of one reading that shows in 8 of
%        10 cases, see sdOfChange, in the scatter of a trial)
%
% Days differ by twice the scatter of a trial. Median of 30 readings in draws of as many
% as the rig has (seed 1).
%
% See also: varianceComponents

1;

function least = leastSeen (readings, trials, days, isPaired, isNamed)
  sizes = zeros (30 / readings, readings);
  for i = 1:rows (sizes)
    list = drawLines (readings, trials, days, isPaired, isNamed);
    sizes(i, :) = arrayfun (@leastOf, groupMeasured (list, {'A'}));
  end
  least = median (sizes(:));
end

function list = drawLines (readings, trials, days, isPaired, isNamed)
  list = [];
  for state = 0:1
    for d = 1:days
      if state == 0 || ~isPaired
        day{d} = 2 * randn (1, readings);
      end
      values = 20 + day{d} + randn (trials, readings);
      name = sprintf ('day%d%d', d, state * ~isPaired);
      list = [list, linesOf(values, state, name(1:end * isNamed))];
    end
  end
end

function list = linesOf (values, state, session)
  states = {'reference', 'now'};
  list = struct ('line', 2, 'model', 1, 'name', '', 'series', '', 'unit', '', ...
                 'at', NaN, 'value', num2cell (values(:)'), 'sd', 0, 'repeats', ...
                 NaN, 'role', 'calibrate', 'tol', 0.1, 'isAbsolute', false, ...
                 'condition', states{state + 1}, 'file', '', 'session', session);
  names = arrayfun (@(t) sprintf ('q%d', t), 1:6, 'UniformOutput', false);
  names = repmat (names, rows (values), 1);
  [list.name] = names{:};
end

function least = leastOf (g)
  [~, ~, least] = sdOfChange (g, g.changed);
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
randn ('twister', 1);
lines = {'readings,trials,days,paired,named,seen'};
for design = [1, 1, 1, 6, 6, 6, 6, 6, 6, 6, 6; 2, 3, 5, 2, 5, 5, 5, 2, 1, 3, 3; ...
              1, 1, 1, 1, 1, 1, 3, 3, 3, 2, 2; 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1; ...
              0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1]
  row = num2cell (design');
  lines{end + 1} = rowText ([row, {leastSeen(row{:})}]);
end
writeTable (argv (){1}, lines);

% SPDX-License-Identifier: GPL-3.0-only
