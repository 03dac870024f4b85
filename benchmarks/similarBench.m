% SIMILARBENCH  What surrogates of a similar bench save on a new one.
%
% CALL: octave-cli benchmarks/similarBench.m NAME SEEDS [CSV]
%
% NAME   'silo' or 'drum': the formulas of standIn, whose every constant is
%        drawn within 25 % for each bench (other drums, other orifices)
% SEEDS  as 1:14
%
% The first bench has 50 runs over the box, whose surrogates are stored as a
% calibration stores them. The second one is calibrated twice, with
% Input.similar and without. One CSV row a seed: runs, worst true deviation of
% the set, whether it is called calibrated; without and with.
%
% See also: similarPriors, standIn, calibrateStandIn

1;

function Z = silo (P, c)
  [rho, mu, mr, mw] = deal (P(:, 1), P(:, 2), P(:, 3), P(:, 4));
  bulk = rho .* (0.64 - c(1) * 0.09 * mu ./ (mu + 0.3 * c(2)) - ...
                 c(3) * 0.12 * sqrt (mr));
  rim = 0.008 * c(4) * (1 + 1.5 * tanh (1.5 * c(5) * mu) + sqrt (mr));
  slope = 14 * c(6) + 32 * mu ./ (mu + 0.35 * c(7)) .* ...
          (0.6 + 0.8 * c(8) * sqrt (mr)) + 6 * c(9) * mw ./ (mw + 0.2);
  Z = [bulk, bulk .* sqrt(9.81) .* (0.06 * c(10) - rim).^2.5, slope];
end

function Z = drum (P, c)
  [rho, mu, mw] = deal (P(:, 1), P(:, 2), P(:, 3));
  [mr, bond, e] = deal (P(:, 4), P(:, 5), P(:, 6));
  bulk = rho .* (0.63 - c(1) * 0.1 * mu ./ (mu + 0.35) - ...
                 0.1 * c(2) * sqrt (mr) - 0.03 * c(3) * tanh (bond));
  grip = mw ./ (mw + 0.08 * c(4));
  slope = 18 * c(5) + ...
          grip .* (22 * c(6) * tanh (1.6 * c(7) * mu) .* ...
                   (0.7 + 0.5 * c(8) * sqrt (mr)) + ...
                   4 * c(9) * bond ./ (bond + 1));
  foot = 13 * c(11) + 28 * mu ./ (mu + 0.4 * c(12)) .* (0.5 + sqrt (mr)) + ...
         4 * sqrt (bond + 0.1) - 3 * c(13) * e.^2;
  Z = [slope, 0.002 * bulk .* sind(slope) .* (1 - 0.15 * c(10) * e), foot, ...
       bulk];
end

% The surrogates of the first bench, as a calibration stores them.
function storeFirst (folder, S, law, c)
  X = S.limits(1, :) + rand (50, numel (S.names)) .* diff (S.limits);
  Z = law (X, c);
  Z = Z .* (1 + 0.01 * randn (size (Z)));
  place = fullfile (folder, 'results', 'surrogates');
  [~, ~] = mkdir (place);
  for t = 1:columns (Z)
    s = fitSurrogate (X, Z(:, t), S.limits, ...
                      struct ('name', S.targetNames{t}));
    saveSurrogate (fullfile (place, sprintf ('KM_fun_%d.txt', t)), s);
  end
  params = cell2struct (num2cell (zeros (numel (S.names), 1)), S.names(:), 1);
  writeAtomic (fullfile (folder, 'results', 'calibration.json'), ...
               jsonencode (struct ('params', params)));
end

here = fileparts (mfilename ('fullpath'));
addpath (here);
startBenchmarks ();
words = argv ();
law = str2func (words{1});
out = stdout;
if numel (words) > 2
  out = fopen (words{3}, 'w');
end
fprintf (out, ['seed,runs,worst,calibrated,runs_similar,worst_similar,' ...
               'calibrated_similar\n']);
for seed = str2num (words{2})
  rand ('twister', seed);
  randn ('twister', seed);
  c = 1 + 0.5 * (rand (2, 13) - 0.5);
  S = standIn (words{1}, seed);
  folder = tempname ();
  storeFirst (folder, S, law, c(1, :));
  S.response = @(P) law (P, c(2, :));
  S.value = S.response (S.truth);
  row = seed;
  for options = {struct(), struct('similar', folder)}
    r = calibrateStandIn (S, seed, 0, options{1});
    row = [row, r.runs, r.worst, r.converged];
  end
  fprintf (out, '%d,%d,%.4f,%d,%d,%.4f,%d\n', row);
  fflush (out);
end
