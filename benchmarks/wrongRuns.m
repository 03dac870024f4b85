% WRONGRUNS  Calibrations among wrong runs: which are found, is the set as good.
%
% CALL: octave-cli benchmarks/wrongRuns.m STANDIN SHARE SEEDS CSVFILE
%
% STANDIN  plain, noisy or rough; SHARE  of wrong runs, 0.12; SEEDS  e.g. 1:100
%
% A wrong run has ended well, and every response is off by 10 to 40 % either way
% (calibrateStandIn), as from a wrong start state. Found are those that the
% surrogates leave out at the end (findBadRuns).
%
% One CSV row per seed: seed, runs, planted, found, good_left_out, worst,
% converged, probability.
%
% See also: peers, calibrateStandIn, findBadRuns

1;

function cells = oneCase (S, seed)
  r = calibrateStandIn (S, seed, 0, struct ());
  truth = S.response (r.state.data.X);
  isWrong = max (abs (r.state.data.Z ./ truth - 1) - 5 * S.noise, [], 2) > 0.04;
  isOut = any (horzcat (r.state.surrogates.leftOut), 2);
  cells = {r.runs, sum(isWrong), sum(isWrong & isOut), sum(isOut & ~isWrong), ...
           r.worst, r.converged, r.probability};
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
S = standIn (given{1});
S.wrong = str2double (given{2});
fillTable (given{4}, ['seed,runs,planted,found,good_left_out,worst,converged,', ...
                      'probability'], {str2num(given{3})}, @(seed) oneCase (S, seed));

% SPDX-License-Identifier: GPL-3.0-only
