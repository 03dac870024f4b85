% BENDS  Calibrations of bent stand-ins: right sets, intervals, runs left out.
%
% CALL: octave-cli benchmarks/bends.m STANDIN SEEDS CSVFILE
% CALL: octave-cli benchmarks/bends.m report CSVFILE...
%
% STANDIN  a name of standIn or bentStandIn, all for the five of bentStandIn;
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
% See also: bentStandIn, calibrateStandIn, coverage

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
  cells = {name, seed, r.runs, sum(strcmp (state.data.stage, 'repeat')), ...
           good, r.worst, r.right, r.converged, r.probability, ...
           all(isfinite (low)), inside, outside, d, chance, toc(started)};
end

function sayBends (files)
  [name, values] = deal ({}, []);
  for file = files
    [~, cells] = readCsvTable (file{1});
    name = [name; cells(:, 1)];
    values = [values; str2double(cells(:, 2:end))];
  end
  [runs, good, right, met] = deal (values(:, 2), values(:, 4), ...
                                   values(:, 6) == 1, values(:, 7) == 1);
  for one = unique (name)'
    own = strcmp (name, one{1});
    use = own & values(:, 9) == 1;
    n = sum (own & met);
    [lo, hi] = binomialInterval (sum (own & met & right), n);
    printf (['%-12s %d seeds: %d called calibrated, %d of them right (', ...
             '%.0f - %.0f %%), stated %.3f; %d sets right; runs ', ...
             'median %g (to %d); good runs left out %d of %d\n'], one{1}, ...
            sum (own), n, sum (own & met & right), 100 * lo, 100 * hi, ...
            mean (values(own & met, 8)), sum (own & right), ...
            median (runs(own)), max (runs(own)), sum (good(own)), ...
            sum (runs(own)));
    [lo, hi] = binomialInterval (sum (values(use, 10)), ...
                                 sum (values(use, 12)));
    printf (['%-12s intervals printed in %d, hold %d of %d parameters = ', ...
             '%.0f %% (%.0f - %.0f %%); set outside its own %d\n'], '', ...
            sum (use), sum (values(use, 10)), sum (values(use, 12)), ...
            100 * sum (values(use, 10)) / sum (values(use, 12)), 100 * lo, ...
            100 * hi, sum (values(use, 11)));
  end
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = argv ();
if strcmp (given{1}, 'report')
  sayBends (given(2:end)');
  return
end
names = given(1);
if strcmp (given{1}, 'all')
  names = {'exponential', 'threshold', 'peak', 'decades', 'ordered', 'clogging'};
end
file = given{3};
if ~isfile (file)
  appendLine (file, ['name,seed,runs,repeats,good_left_out,worst,right,', ...
                     'converged,probability,printed,inside,outside_set,', ...
                     'parameters,chance,seconds']);
end
for seed = str2num (given{2})
  for name = names
    if isempty (strfind (fileread (file), sprintf ("\n%s,%d,", name{1}, seed)))
      appendLine (file, rowText (oneBend (name{1}, seed)));
    end
  end
end
sayBends ({file});
