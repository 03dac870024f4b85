% BENDS  Calibrations of bent stand-ins: right sets, intervals, runs left out.
%
% CALL: octave-cli benchmarks/bends.m STANDIN SEEDS CSVFILE
%
% STANDIN  a name of standIn or bentStandIn, all for those of bentStandIn;
%          SEEDS  e.g. 1:100; CSVFILE  gets a row a seed; seeds that stand in it
%          are not made again, so two processes may share the seeds, each with a
%          file of its own
%
% Each seed has another truth; what is measured is one noisy run there (of
% clogging the usual outcome). A calibration as DEcalioc does it, and what it
% says at the end. Row: name, seed, runs, repeats (suspects run once more),
% good_left_out (runs left out that are within 5 scatters of the truth; of
% clogging none counts), worst, right (truly within the tolerances), converged,
% probability, printed (intervals are given), inside (parameters whose 90 %
% interval holds the truth), outside_set (parameters of the set outside its own
% interval), parameters, chance (of clogging, at the set), seconds.
%
% See also: bentStandIn, calibrateStandIn

1;

function cells = oneBend (name, seed)
  started = tic ();
  S = standIn (name, seed);
  randn ('twister', 3e6 + seed);
  S.value = S.value .* (1 + S.noise .* randn (size (S.value)));
  r = calibrateStandIn (S, seed, 0, struct ());
  state = r.state;
  known = knownParameters (state, r.problem);
  d = numel (S.names);
  low = known.interval90(1, :);
  high = known.interval90(2, :);
  inside = sum (S.truth >= low & S.truth <= high);
  outside = sum (r.params < low | r.params > high);
  chance = 0;
  good = 0;
  if isfield (S, 'chance')
    chance = S.chance (r.params);
  else
    off = max (abs (state.data.Z ./ S.response (state.data.X) - 1) ./ ...
               S.noise, [], 2);
    good = sum (any (horzcat (state.surrogates.leftOut), 2) & off < 5);
  end
  cells = {r.runs, sum(strcmp (state.data.stage, 'repeat')), ...
           good, r.worst, r.right, r.converged, r.probability, ...
           all(isfinite (low)), inside, outside, d, chance, toc(started)};
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
names = given(1);
if strcmp (given{1}, 'all')
  names = {'exponential', 'threshold', 'peak', 'decades', 'ordered', ...
           'clogging', 'cloggingTold'};
end
fillTable (given{3}, ['name,seed,runs,repeats,good_left_out,worst,right,converged,', ...
                      'probability,printed,inside,outside_set,parameters,chance,', ...
                      'seconds'], {names, str2num(given{2})}, @oneBend);

% SPDX-License-Identifier: GPL-3.0-only
