% PEERS  DEcalioc on the stand-ins: runs to its own stop, and the truth then.
%
% CALL: octave-cli benchmarks/peers.m STANDIN FAIL SEEDS [CSVFILE]
%
% STANDIN  a name of standIn; FAIL  share of failing runs; SEEDS  e.g. 1:100
%
% One CSV row a seed: seed, runs, failed, infill, verify, first_obs,
% first_true, worst, converged, probability, seconds of processor. Input.numOfSam is
% d + 3, one run at a time; all else is as the toolbox has it by
% default. The last line says how far the stated probability holds. Where a stand-in
% has tolerances of its own, misses are stretched so that these are the 1 %.
% benchmarks/peers.py runs this beside the peers.
%
% See also: calibrateStandIn, standIn

1;

function [row, steps] = onePeer (S, seed, fail)
  started = cputime ();
  r = calibrateStandIn (S, seed, fail, struct ());
  part = 100 * givenField (S, 'tol', 0.01);
  miss = @(params) max (abs (S.response (params) ./ S.value - 1) ./ part);
  row = [seed, r.runs, r.failed, r.infill, r.verify, r.firstObserved, ...
         r.firstTrue, miss(r.params), r.converged, r.probability, cputime() - started];
  steps = zeros (0, 2);
  for step = r.state.history
    steps(end + 1, :) = [step.probability, miss(step.params) < 0.01];
  end
  printf ('%4d  runs %3d  worst %.2f %%  probability %.3f  %4.1f s\n', ...
          seed, r.runs, 100 * row(8), r.probability, row(end));
end

function sayPeerSummary (R, name, fail)
  good = sum (R(:, 8) < 0.01);
  printf (['%s, %g %% failing: %d of %d sets truly within 1 %%, runs ' ...
           'median %g (%d to %d), worst set %.2f %%, converged %d, stated ' ...
           'probability %.2f in the mean\n'], name, ...
          100 * fail, good, rows (R), median (R(:, 2)), min (R(:, 2)), ...
          max (R(:, 2)), 100 * max (R(:, 8)), sum (R(:, 9)), mean (R(:, 10)));
end

% Probability stated after a run, and the share of sets that were right then.
function sayReliability (steps)
  edges = [0, 0.4, 0.6, 0.7, 0.8, 0.9, 0.95, 1];
  printf ('stated: right (steps) ');
  for k = 1:numel (edges) - 1
    in = steps(:, 1) >= edges(k) & steps(:, 1) < edges(k + 1);
    printf ('  %.2f: %.2f (%d)', mean (steps(in, 1)), mean (steps(in, 2)), ...
            sum (in));
  end
  printf ('\n');
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
fail = str2double (given{2});
seeds = sscanf (given{3}, '%d:%d')';
R = [];
steps = zeros (0, 2);
for seed = seeds(1):seeds(end)
  S = standIn (given{1}, seed);
  [R(end + 1, :), own] = onePeer (S, seed, fail);
  steps = [steps; own];
end
sayPeerSummary (R, S.name, fail);
sayReliability (steps);
if numel (given) > 3
  lines = arrayfun (@(i) rowText (num2cell (R(i, :))), 1:rows (R), ...
                    'UniformOutput', false);
  writeTable (given{4}, [{['seed,runs,failed,infill,verify,first_obs,first_true,', ...
                           'worst,converged,probability,seconds']}, lines]);
end

% SPDX-License-Identifier: GPL-3.0-only
