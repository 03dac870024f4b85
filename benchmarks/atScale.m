% ATSCALE  Many parameters, many cores: runs, batches and hours of a calibration.
%
% CALL: octave-cli benchmarks/atScale.m PARAMETERS SETS SEEDS CSV
%       octave-cli benchmarks/atScale.m report CSV
%
%   PARAMETERS  e.g. 2,4,8,12;  SETS  parameter sets at a time after the plan
%               (Input.slurm.sets), e.g. 1,8,32;  SEEDS  e.g. 1:10
%   CSV         table, to which one row a calibration is added; what stands in it
%               is not run again
%
% Each calibration is DEcalioc's own, on a formula (manyParameters) of two models
% whose runs scatter by 1 % and of which 5 % fail. batches of the CSV are the runs
% of each batch, one after the other, as in 10+8+2.
%
% The clock of the report is simulated, 50 times for each calibration: a run
% takes 1.5 hours in the median (90 % between half an hour and 4.5 hours) and 4
% cores; one that fails is made once more with another seed, after the others of
% its batch. A batch begins when the one before has ended; within it a run starts
% as soon as cores are free, as executeLocal and Slurm do it. Nothing else takes
% time (seconds of Octave are apart).
%
%   over the bound  the bound is what the same batches take at least: of each the
%           longer of its work over all cores and its longest run with its
%           repetition; no order of the runs of a batch is quicker
%
% See also: calibrateStandIn

1;

function calibrateAll (parameters, sets, seeds, file)
  addpath (fileparts (mfilename ('fullpath')));
  startBenchmarks ();
  pkg ('load', 'stk');
  pkg ('load', '-nodeps', 'struct', 'optim');
  done = {};
  if isfile (file)
    done = regexp (fileread (file), '^\d+,\d+,\d+', 'match', 'lineanchors');
  else
    appendLine (file, ['parameters,sets,seed,runs,batches,failed,calibrated,', ...
                       'right,octave']);
  end
  [n, d, seed] = ndgrid (sets, parameters, seeds);
  for one = [d(:), n(:), seed(:)]'
    if ~any (strcmp (done, sprintf ('%d,%d,%d', one)))
      appendLine (file, rowText (oneCalibration (one(1), one(2), one(3))));
    end
  end
end

function cells = oneCalibration (d, n, seed)
  % handles share no variable; a map is one for all
  book = containers.Map ({'batches'}, {zeros(1, 0)}, 'UniformValues', false);
  S = manyParameters (d, seed);
  law = S.response;
  S.response = @(P) noted (book, P, law);
  start = cputime ();
  % of runs that fail one in twenty fails with another seed, too
  r = calibrateStandIn (S, seed, 0.05^2, struct ('sets', n, 'maxFunEvals', 40 * d));
  seconds = cputime () - start;
  batches = book('batches');
  % the sets of the score come last
  batches = batches(1:find (cumsum (batches) >= r.runs, 1));
  % each set is a run of both models
  cells = {d, n, seed, 2 * r.runs, sprintf('%d+', 2 * batches)(1:end - 1), ...
           2 * r.failed, r.converged, r.right, seconds};
end

function Z = noted (book, P, law)
  book('batches') = [book('batches'), rows(P)];
  Z = law (P);
end

% Angles, rates and densities of two rigs: each parameter saturates, three of
% four act on a result, and two of its parameters multiply.
function S = manyParameters (d, seed)
  rand ('twister', 7e5 + 100 * d + seed);
  T = 2 * max (1, min (3, floor (d / 2)));
  W = rand (d, T) .* (rand (d, T) < 0.75);
  W(sub2ind (size (W), mod (0:T - 1, d) + 1, 1:T)) = 1;   % none without effect
  half = 0.2 + 0.6 * rand (1, d);
  pair = [mod(0:T - 1, d); mod(1:T, d)] + 1;
  law = @(P) 10 + 10 * ((P ./ (P + half)) * W) ./ sum (W, 1) + ...
             4 * P(:, pair(1, :)) .* P(:, pair(2, :));
  truth = 0.15 + 0.7 * rand (1, d);
  S = struct ('name', 'many', 'names', ...
              {arrayfun(@(k) sprintf ('p%d', k), 1:d, 'UniformOutput', false)}, ...
              'limits', [zeros(1, d); ones(1, d)], 'targetNames', ...
              {arrayfun(@(k) sprintf ('r%d', k), 1:T, 'UniformOutput', false)}, ...
              'response', law, 'value', law (truth), 'noise', 0.01, ...
              'model', 1 + mod (0:T - 1, 2), 'tol', 0.03 * ones (1, T));
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

function report (file)
  [head, cells] = readCsvTable (file);
  number = @(name) cellfun (@str2double, cells(:, strcmp (head, name)));
  batches = cellfun (@(text) str2double (strsplit (text, '+')), ...
                     cells(:, strcmp (head, 'batches')), 'UniformOutput', false);
  isGood = number ('calibrated') == 1;
  isRight = isGood & number ('right') == 1;
  [runs, octave] = deal (number ('runs'), number ('octave'));
  cores = [16, 64, 256, 1024];
  printf (['| parameters | sets at a time | calibrated, right | runs | batches | ', ...
           'Octave (s) | hours on %s cores | over the bound, 256 |\n|%s\n'], ...
          sprintf ('%d, ', cores)(1:end - 2), repmat ('---|', 1, 8));
  pairs = [number('parameters'), number('sets')];
  for pair = unique (pairs, 'rows')'
    of = find (all (pairs == pair', 2))';
    [hours, over] = deal (zeros (1, numel (cores)));
    for c = 1:numel (cores)
      [hours(c), over(c)] = clockOf (batches(of), cores(c) / 4);
    end
    printf ('| %d | %d | %d of %d, %d | %g (%g) | %g | %.0f | %s | %.2f |\n', pair, ...
            sum (isGood(of)), numel (of), sum (isRight(of)), median (runs(of)), ...
            max (runs(of)), median (cellfun (@numel, batches(of))), ...
            median (octave(of)), sprintf ('%.0f, ', hours)(1:end - 2), over(3));
  end
end

% Medians over calibrations and 50 clocks of each.
function [hours, over] = clockOf (batches, slots)
  randn ('twister', 1);
  rand ('twister', 1);
  T = zeros (0, 2);
  for own = batches(:)'
    for i = 1:50
      [hours, bound] = timed (own{1}, slots);
      T(end + 1, :) = [hours, bound];
    end
  end
  hours = median (T(:, 1));
  over = median (T(:, 1) ./ T(:, 2));
end

%!test
%! % a test of this file is a small calibration of its own
%! file = tempname ();
%! program = fullfile (fileparts (which ('appendLine')), 'atScale.m');
%! [status, out] = system (sprintf ('octave-cli --norc %s 2 4 1 %s 2>&1', ...
%!                                  shellQuote (program), shellQuote (file)));
%! assert (status == 0, out);
%! row = strsplit (strsplit (fileread (file), "\n"){2}, ',');
%! assert (str2double (row([1:3, 7])), [2, 4, 1, 1]);
%! assert (sum (str2double (strsplit (row{5}, '+'))), str2double (row{4}));
%! [status, out] = system (sprintf ('octave-cli --norc %s report %s 2>&1', ...
%!                                  shellQuote (program), shellQuote (file)));
%! assert (~isempty (regexp (out, '\| 2 \| 4 \| 1 of 1, ')), out);

args = argv ()';
if numel (args) == 2 && strcmp (args{1}, 'report')
  addpath (fileparts (mfilename ('fullpath')));
  startBenchmarks ();
  report (args{2});
elseif numel (args) == 4
  calibrateAll (str2num (args{1}), str2num (args{2}), str2num (args{3}), args{4});
end
