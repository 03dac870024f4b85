% IMPORTEDTABLE  Calibrations beside an imported table that is off.
%
% CALL: octave-cli benchmarks/importedTable.m OFF REPLICATES SEEDS CSV
%
%   OFF         by how much the discharge of the table takes longer than that of
%               today's script, e.g. 0,0.02,0.04,0.08 (tolerance 0.05)
%   REPLICATES  Input.replicates, e.g. 1,4
%   SEEDS       e.g. 1:25, each with a truth of its own
%   CSV         table, to which one row a calibration is added; those that stand
%               in it are not made again
%
% A bin of two parameters and two results, as formulas (binOf). The table has 60
% rows. Right is a set called calibrated whose true means are within both
% tolerances.
%
% See also: calibrateStandIn, binomialInterval

1;

function cells = oneCase (off, replicates, seed)
  S = binOf (seed);
  S.library = tableOf (S, off, seed);
  r = calibrateStandIn (S, seed, 0, struct ('replicates', replicates));
  final = r.state.final;
  share = max (abs (S.response (final.params) ./ S.value - 1) ./ S.tol);
  isOwn = ~ismember (r.state.data.stage, {'import', 'library'});
  cells = {double(final.converged), double(share < 1), share, final.probability, ...
           sum(isOwn), double(~isempty (r.state.misled)), final.ending.code};
end

% Discharge time and angle of a bin by friction and rolling friction.
function S = binOf (seed)
  S = struct ('names', {{'friction', 'rollingFriction'}}, ...
              'limits', [0.3, 0.1; 0.7, 0.3], ...
              'targetNames', {{'tDischarge', 'angle'}}, 'model', [1, 1], ...
              'tol', [0.05, 0.05], 'noise', [0.017, 0.033]);
  S.response = @(P) [0.36 + 0.5 * P(:, 1) + 0.1 * P(:, 2), ...
                     26 * (1 - exp (-P(:, 2) / 0.1)) + 10 * (P(:, 1) - 0.4)];
  rand ('twister', 1e6 + seed);
  S.truth = S.limits(1, :) + (0.1 + 0.8 * rand (1, 2)) .* diff (S.limits);
  S.value = S.response (S.truth);
end

function data = tableOf (S, off, seed)
  rand ('twister', 2e6 + seed);
  randn ('twister', 2e6 + seed);
  X = S.limits(1, :) + rand (60, 2) .* diff (S.limits);
  Z = S.response (X) .* [1 + off, 1] .* (1 + S.noise .* randn (60, 2));
  data = addRows (newData (2, 2), X, Z, ones (60, 1), 'import');
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
args = argv ();
numbers = cellfun (@(a) str2num (['[', a, ']']), args(1:3)', 'UniformOutput', false);
fillTable (make_absolute_filename (args{4}), ...
           ['off,replicates,seed,converged,right,worst,probability,runs,rejected,', ...
            'ending'], numbers, @oneCase);

% SPDX-License-Identifier: GPL-3.0-only
