% WRONGRUNS  Calibrations among wrong runs: which are found, is the set as good.
%
% CALL: octave-cli benchmarks/wrongRuns.m STANDIN SHARE SEEDS [CSVFILE]
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

function row = oneCase (S, seed)
  r = calibrateStandIn (S, seed, 0, struct ());
  truth = S.response (r.state.data.X);
  isWrong = max (abs (r.state.data.Z ./ truth - 1) - 5 * S.noise, [], 2) > 0.04;
  isOut = any (horzcat (r.state.surrogates.leftOut), 2);
  row = [seed, r.runs, sum(isWrong), sum(isWrong & isOut), ...
         sum(isOut & ~isWrong), r.worst, r.converged, r.probability];
  printf (['%4d  runs %3d  wrong %d, found %d, good ones left out %d  ' ...
           'worst %.2f %%  probability %.3f\n'], row(1:5), 100 * r.worst, ...
          r.probability);
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
S = standIn (given{1});
S.wrong = str2double (given{2});
seeds = sscanf (given{3}, '%d:%d')';
R = [];
for seed = seeds(1):seeds(end)
  R(end + 1, :) = oneCase (S, seed);
end
printf (['%s, %g %% wrong: %d of %d wrong runs found, all of them in %d ' ...
         'of %d calibrations; a good run left out in %d; %d sets truly ' ...
         'within 1 %%, runs median %g (%d to %d), worst set %.2f %%\n'], ...
        given{1}, 100 * S.wrong, sum (R(:, 4)), sum (R(:, 3)), ...
        sum (R(:, 4) == R(:, 3)), rows (R), sum (R(:, 5) > 0), ...
        sum (R(:, 6) < 0.01), median (R(:, 2)), min (R(:, 2)), ...
        max (R(:, 2)), 100 * max (R(:, 6)));
if numel (given) > 3
  lines = arrayfun (@(i) rowText (num2cell (R(i, :))), 1:rows (R), ...
                    'UniformOutput', false);
  writeTable (given{4}, [{['seed,runs,planted,found,good_left_out,worst,converged,', ...
                           'probability']}, lines]);
end
