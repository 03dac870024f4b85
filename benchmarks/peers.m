% PEERS  DEcalioc on the stand-ins: runs to its own stop, and the truth then.
%
% CALL: octave-cli benchmarks/peers.m STANDIN FAIL SEEDS [CSVFILE]
%
% STANDIN  plain, noisy or rough; FAIL  share of failing runs; SEEDS  e.g. 1:100
%
% One CSV row a seed: seed, runs, failed, infill, verify, first_obs,
% first_true, worst, converged, probability, seconds. Input.numOfSam is
% planSize (d) = d + 3, one run at a time; all else is as the toolbox has it by
% default. benchmarks/peers.py runs this beside the peers.
%
% See also: calibrateStandIn, standIn

1;

function row = onePeer (S, seed, fail)
  started = tic ();
  r = calibrateStandIn (S, seed, fail, struct ());
  row = [seed, r.runs, r.failed, r.infill, r.verify, r.firstObserved, ...
         r.firstTrue, r.worst, r.converged, r.probability, toc(started)];
  printf ('%4d  runs %3d  worst %.2f %%  probability %.3f  %4.1f s\n', ...
          seed, r.runs, 100 * r.worst, r.probability, row(end));
end

function sayPeerSummary (R, name, fail)
  good = sum (R(:, 8) < 0.01);
  printf (['%s, %g %% failing: %d of %d sets truly within 1 %%, runs ' ...
           'median %g (%d to %d), worst set %.2f %%, converged %d, stated ' ...
           'probability %.2f in the mean\n'], name, ...
          100 * fail, good, rows (R), median (R(:, 2)), min (R(:, 2)), ...
          max (R(:, 2)), 100 * max (R(:, 8)), sum (R(:, 9)), mean (R(:, 10)));
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
S = standIn (given{1});
fail = str2double (given{2});
seeds = sscanf (given{3}, '%d:%d')';
R = [];
for seed = seeds(1):seeds(end)
  R(end + 1, :) = onePeer (S, seed, fail);
end
sayPeerSummary (R, S.name, fail);
if numel (given) > 3
  writeMatrix (given{4}, R, {'seed', 'runs', 'failed', 'infill', 'verify', ...
                             'first_obs', 'first_true', 'worst', ...
                             'converged', 'probability', 'seconds'});
end
