% MATERIALS  One material after another on one bench: what a library saves.
%
% CALL: octave-cli benchmarks/materials.m STANDIN CHAINS MATERIALS [CSV [SPOIL]]
%
% STANDIN    a name of standIn; CHAINS  e.g. 1:5, numbers of the libraries
% MATERIALS  how many each of them serves (20)
% SPOIL      'wall': the rig of the first two materials had another wall and
%            nobody noted it: all their responses are off by 5 to 15 %; 'fifth':
%            a fifth of all runs is wrong, by 10 to 40 %; 'beyond X': runs up to
%            X of the box beyond the limits count (0.5), and no material but the
%            first is calibrated from scratch
%
% Each material has a truth from the whole box of the stand-in and limits that
% are shifted by up to half a box, each parameter by itself (not where that
% would shut out the truth). It is calibrated with the runs of those before it
% and, for comparison, from scratch. One CSV row a material: chain, material,
% new runs, worst (true relative residual), rows taken from the library, it was
% trusted (0, 1), seconds; runs, worst and seconds from scratch; floor.
%
% floor: how many runs at the true set would make 0.95 of what the library tells
% of it, by its surrogates, if each of them gave the targets to the digit and
% the scatter were known. And what a calibration without surrogates would need
% that knew the true set and had only to confirm it ("by runs alone").
%
% See also: calibrateStandIn, nearRows, trustLibrary

1;

function S = drawMaterial (S, chain, number, how)
  rand ('twister', 7e5 + 1000 * chain + number);
  box = S.limits;
  width = diff (box);
  S.truth = box(1, :) + rand (1, columns (box)) .* width;
  S.limits = box + (rand (1, columns (box)) - 0.5) .* width;
  isOut = S.truth < S.limits(1, :) | S.truth > S.limits(2, :);
  S.limits(:, isOut) = box(:, isOut);
  if strcmp (how, 'fifth')
    S.wrong = 0.2;
  elseif strcmp (how, 'wall') && number <= 2
    rand ('twister', chain);
    T = numel (S.targetNames);
    off = (0.05 + 0.1 * rand (1, T)) .* sign (rand (1, T) - 0.5);
    today = S.response;
    S.response = @(P) today (P) .* (1 + off);
  end
  S.value = S.response (S.truth);
end

function n = floorOf (S, r)
  library = keepRows (S.library, nearRows (S.library, r.problem));
  [~, v] = predictSurrogate (fitSurrogates (library, r.problem), S.truth);
  n = 0;
  while probabilityOf (0, 1 ./ sqrt (1 ./ v + n ./ (S.noise .* S.value).^2), ...
                       0.01 * abs (S.value)) < 0.95
    n = n + 1;
  end
end

function p = probabilityOf (off, sd, tol)
  half = @(x) 0.5 * erf (x ./ sd / sqrt (2));
  p = prod (half (tol - off) + half (tol + off));
end

% Runs until 0.95, drawn 2000 times: residuals and tolerances in percent.
function n = byRunsAlone (S)
  n = zeros (1, 2000);
  noise = 100 * S.noise .* ones (size (S.value));
  randn ('twister', 1);
  for i = 1:2000
    [total, p] = deal (0);
    while p < 0.95
      n(i) = n(i) + 1;
      total = total + noise .* randn (size (noise));
      p = probabilityOf (total / n(i), noise / sqrt (n(i)), 1);
    end
  end
end

function R = oneChain (name, chain, most, how)
  R = zeros (0, 11);
  part = sscanf (how, 'beyond %g');
  S = standIn (name, 1);
  runs = newData (numel (S.names), numel (S.targetNames));
  for k = 1:most
    S = drawMaterial (standIn (name, 1), chain, k, how);
    started = tic ();
    plain = struct ('runs', NaN, 'worst', NaN);
    if k == 1 || isempty (part)
      plain = calibrateStandIn (S, 1000 * chain + k, 0, struct ());
    end
    seconds = toc (started);
    started = tic ();
    r = plain;
    least = NaN;
    if k > 1
      S.library = runs;
      S.beyond = part;
      r = calibrateStandIn (S, 1000 * chain + k, 0, struct ());
    end
    took = toc (started);
    if k > 1 && isempty (how)
      least = floorOf (S, r);
    end
    data = r.state.data;
    isNew = ~strcmp (data.stage, 'library');
    runs = addRows (runs, data.X(isNew, :), data.Z(isNew, :), ...
                    data.replicate(isNew), 'library');
    R(end + 1, :) = [chain, k, r.runs, r.worst, sum(~isNew), any(~isNew), ...
                     took, plain.runs, plain.worst, seconds, least];
    printf (['%3d %3d  runs %2d  worst %.2f %%  of the library %3d ' ...
             '%5.1f s   scratch %2d  %.2f %% %5.1f s  floor %d\n'], ...
            chain, k, r.runs, 100 * r.worst, sum (~isNew), R(end, 7), ...
            plain.runs, 100 * plain.worst, seconds, least);
    fflush (stdout);
  end
end

function sayMaterials (R, name)
  later = R(:, 2) >= min (3, max (R(:, 2)));
  isLate = R(:, 2) > max (R(:, 2)) / 2;
  n = sum (later);
  over = R(later, 3) > 1.1 * R(later, 8);
  printf (['%s, from the third material on: right %d of %d (from scratch ' ...
           '%d), new runs median %g, at most %d (from scratch %g, %d), ' ...
           'second %g; over scratch by more than 10 %%: %d of %d; core ' ...
           'seconds %.1f (%.1f)\n'], name, sum (R(later, 4) < 0.01), n, ...
          sum (R(later, 9) < 0.01), median (R(later, 3)), ...
          max (R(later, 3)), median (R(later, 8)), max (R(later, 8)), ...
          median (R(R(:, 2) == 2, 3)), sum (over), n, mean (R(later, 7)), ...
          mean (R(later, 10)));
  printf (['floor: median %g; the second half of each chain: %g new runs, ' ...
           'floor %g\n'], median (R(later, 11)), median (R(isLate, 3)), ...
          median (R(isLate, 11)));
  alone = byRunsAlone (standIn (name, 1));
  printf ('by runs alone at the true set: median %g, quartiles %g and %g\n', ...
          quantile (alone', [0.5; 0.25; 0.75]));
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
given = [argv(); {''; ''}];
R = [];
how = '';
if numel (given) > 6
  how = given{5};
end
for chain = sscanf (given{2}, '%d:%d')(1):sscanf (given{2}, '%d:%d')(end)
  R = [R; oneChain(given{1}, chain, str2double (given{3}), how)];
end
sayMaterials (R, given{1});
if ~isempty (given{4})
  writeMatrix (given{4}, R, {'chain', 'material', 'runs', 'worst', 'rows', ...
                             'trusted', 'seconds', 'scratch_runs', ...
                             'scratch_worst', 'scratch_seconds', 'floor'});
end
