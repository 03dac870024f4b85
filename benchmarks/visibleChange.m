% VISIBLECHANGE  How large a change of a reading must be to be seen.
%
% CALL: octave-cli benchmarks/visibleChange.m CSV
%
% Six readings of a rig and of a change, days that differ by twice the scatter of
% a trial. For each way to measure: 1.96 standard uncertainties of the change of
% one reading, with Student's t for the freedoms that the lines leave, in the
% scatter of a trial; median of 5 draws (seed 1) of six readings each.
%
% See also: varianceComponents

1;

function least = leastSeen (trials, days, isPaired, isNamed)
  sizes = zeros (5, 6);
  for i = 1:5
    list = drawLines (trials, days, isPaired, isNamed);
    sizes(i, :) = arrayfun (@leastOf, groupMeasured (list, {'A'}));
  end
  least = median (sizes(:));
end

function list = drawLines (trials, days, isPaired, isNamed)
  list = [];
  for state = 0:1
    for d = 1:days
      if state == 0 || ~isPaired
        day{d} = 2 * randn (1, 6);
      end
      values = 20 + day{d} + randn (trials, 6);
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
  [sd, freedom] = sdOfChange (g, g.changed);
  least = sd / studentFactor (freedom) * studentQuantile (0.975, freedom);
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
randn ('twister', 1);
answers = {'no', 'yes'};
lines = {'trials,days,sameDays,named,seenFrom'};
for design = [2, 5, 5, 5, 2, 1, 3, 3; 1, 1, 1, 3, 3, 3, 2, 2; ...
              0, 0, 0, 0, 0, 1, 0, 1; 0, 0, 1, 1, 1, 1, 1, 1]
  least = leastSeen (design(1), design(2), design(3), design(4));
  lines{end + 1} = sprintf ('%d,%d,%s,%s,%.1f', design(1), design(2), ...
                            answers{design(3) + 1}, answers{design(4) + 1}, least);
end
writeTable (argv (){1}, lines);
