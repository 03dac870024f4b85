% ATSCALE  Many parameters, many cores: runs, batches and hours of a calibration.
%
% CALL: octave-cli benchmarks/atScale.m PARAMETERS SETS SEEDS CSV
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
% See also: calibrateStandIn, scaleTables

1;

function calibrateAll (parameters, sets, seeds, file)
  addpath (fileparts (mfilename ('fullpath')));
  startBenchmarks ();
  pkg ('load', 'stk');
  pkg ('load', '-nodeps', 'struct', 'optim');
  fillTable (file, 'parameters,sets,seed,runs,batches,failed,calibrated,right,octave', ...
             {parameters, sets, seeds}, @oneCalibration);
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
  cells = {2 * r.runs, sprintf('%d+', 2 * batches)(1:end - 1), ...
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

%!test
%! % a test of this file is a small calibration of its own
%! file = tempname ();
%! program = fullfile (fileparts (which ('fillTable')), 'atScale.m');
%! [status, out] = system (sprintf ('octave-cli --norc %s 2 4 1 %s 2>&1', ...
%!                                  shellQuote (program), shellQuote (file)));
%! assert (status == 0, out);
%! [~, row] = readCsvTable (file);
%! assert (str2double (row([1:3, 7])), [2, 4, 1, 1]);
%! assert (sum (str2double (strsplit (row{5}, '+'))), str2double (row{4}));

args = argv ()';
if numel (args) == 4
  calibrateAll (str2num (args{1}), str2num (args{2}), str2num (args{3}), args{4});
end

% SPDX-License-Identifier: GPL-3.0-only
