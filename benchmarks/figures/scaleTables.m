% SCALETABLES  The table of many parameters and cores, by a simulated clock.
%
% CALL: TABLES = scaleTables ()
%
%   TABLES  struct of handles, see calibrationTables
%
% The clock is simulated, 50 times for each calibration: a run takes 1.5 hours in
% the median (90 % between half an hour and 4.5 hours) and 4 cores; one that
% fails (5 %) is made once more with another seed, after the others of its batch.
% A batch begins when the one before has ended; within it a run starts as soon as
% cores are free, as executeLocal and Slurm do it. Nothing else takes time.
%
%   over the bound  the bound is what the same batches take at least: of each the
%           longer of its work over all cores and its longest run with its
%           repetition; no order of the runs of a batch is quicker
%
% See also: atScale

function tables = scaleTables ()
  tables = struct ('atScale', @atScaleTable);
end

function text = atScaleTable (read)
  list = read ('atScale');
  number = @(name) cellfun (@str2double, {list.(name)})';
  batches = cellfun (@(text) str2double (strsplit (text, '+')), {list.batches}, ...
                     'UniformOutput', false);
  isGood = number ('calibrated') == 1;
  isRight = isGood & number ('right') == 1;
  [runs, octave] = deal (number ('runs'), number ('octave'));
  cores = [16, 64, 256, 1024];
  pairs = [number('parameters'), number('sets')];
  rows_ = cell (0, 8);
  for pair = unique (pairs, 'rows')'
    of = find (all (pairs == pair', 2))';
    [hours, over] = deal (zeros (1, numel (cores)));
    for c = 1:numel (cores)
      [hours(c), over(c)] = clockOf (batches(of), cores(c) / 4);
    end
    rows_(end + 1, :) = ...
      {sprintf('%d', pair(1)), sprintf('%d', pair(2)), ...
       sprintf('%d of %d, %d', sum (isGood(of)), numel (of), sum (isRight(of))), ...
       sprintf('%g (%g)', median (runs(of)), max (runs(of))), ...
       sprintf('%g', median (cellfun (@numel, batches(of)))), ...
       sprintf('%.0f', median (octave(of))), ...
       sprintf('%.0f, ', hours)(1:end - 2), sprintf('%.2f', over(3))};
  end
  text = markdownTable ({'parameters', 'sets at a time', 'calibrated, right', ...
                         'runs', 'batches', 'Octave (s)', ...
                         'hours on 16, 64, 256, 1024 cores', ...
                         'over the bound, 256'}, rows_);
end

% Medians over calibrations and 50 clocks of each.
function [hours, over] = clockOf (batches, slots)
  randn ('twister', 1);
  rand ('twister', 1);
  T = zeros (0, 2);
  for own = batches
    for i = 1:50
      [hours, bound] = timed (own{1}, slots);
      T(end + 1, :) = [hours, bound];
    end
  end
  hours = median (T(:, 1));
  over = median (T(:, 1) ./ T(:, 2));
end

% RUNS: 1 x b, of each batch.
function [hours, bound] = timed (runs, slots)
  [hours, bound] = deal (0);
  for n = runs
    last = 1.5 * exp (0.67 * randn (1, n));
    again = 1.5 * exp (0.67 * randn (1, n)) .* (rand (1, n) < 0.05);
    hours = hours + makespan (last, again(again > 0), slots);
    bound = bound + max ([sum(last + again) / slots, max(last + again)]);
  end
end

% Those that failed come once the others have ended, as runJobs has it.
function hours = makespan (first, second, slots)
  hours = 0;
  for list = {first, second}
    n = min (slots, numel (list{1}));
    free = [list{1}(1:n), 0];
    for one = list{1}(n + 1:end)
      [at, k] = min (free(1:n));
      free(k) = at + one;
    end
    hours = hours + max (free);
  end
end

%!test
%! % one calibration of two batches: 2 cores for a run of 4 do not shorten them
%! list = struct ('parameters', '2', 'sets', '1', 'runs', '6', 'batches', '4+2', ...
%!                'calibrated', '1', 'right', '0', 'octave', '3.4');
%! text = scaleTables ().atScale (@(name) list);
%! assert (~isempty (strfind (text, '| 2 | 1 | 1 of 1, 0 | 6 (6) | 2 | 3 | ')), text);

% SPDX-License-Identifier: GPL-3.0-only
