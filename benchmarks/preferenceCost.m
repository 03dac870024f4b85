% PREFERENCECOST  What a preference for a large time step costs a calibration.
%
% CALL: octave-cli benchmarks/preferenceCost.m CASES WRL SEEDS CSV
%
%   CASES  of exact (2 parameters, 2 results, no scatter), noisy (the same, a run
%          scatters by half of the tolerances), open (5 parameters, 2 results,
%          noisy: three directions are flat), by commas
%   WRL    weights of the preference, e.g. 0,0.5,1
%   SEEDS  e.g. 1:20;  CSV  table, to which one row a calibration is added
%
% Density and friction of a filled cylinder (rho, mu), tolerances 2 and 3 %, a plan
% of 15 runs; the
% preference is that of costFunction.m for the Rayleigh time, which grows with
% sqrt (rho). Used: by how much the preference moved the expected results, in
% tolerances and in their standard errors (preferredSet).
%
% See also: calibrateStandIn, preferredSet

1;

function cells = oneCase (kind, w, seed)
  S = cylinder (kind);
  [value, ends] = deal (S.value(:), sqrt (S.limits(:, 1)));
  S.cost = @(p, f) [(f(p) - value) ./ value; w * (ends(2) - sqrt (p(1))) / diff(ends)];
  r = calibrateStandIn (S, seed, 0, struct ());
  p = r.params;
  off = abs (S.response (p) ./ S.value - 1) ./ S.tol;
  used = givenField (r.state.found, 'preference', []);
  if isempty (used)
    used = struct ('share', NaN, 'spread', NaN);
  end
  distance = norm ((p - S.truth) ./ diff (S.limits)) / sqrt (numel (p));
  cells = {double(r.converged), double(all (off < 1)), max(off), distance, ...
           (sqrt (p(1)) - ends(1)) / diff(ends), used.share, used.spread, r.runs};
end

function S = cylinder (kind)
  S = standIn ('plain');
  S.truth = [653.2, 0.476, 0.5, 0.05, 0.05];
  use = 1:2;
  if strcmp (kind, 'open')
    use = 1:5;
  end
  rest = S.truth(numel (use) + 1:end);
  whole = S.response;
  S.response = @(P) whole ([P, repmat(rest, rows (P), 1)]);
  S.names = S.names(use);
  S.limits = S.limits(:, use);
  S.truth = S.truth(use);
  S.value = S.response (S.truth);
  S.tol = [0.02, 0.03];
  S.plan = 15;
  S.noise = 0.5 * S.tol * ~strcmp (kind, 'exact');
end

addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
args = argv ();
numbers = cellfun (@(a) str2num (['[', a, ']']), args(2:3)', 'UniformOutput', false);
fillTable (make_absolute_filename (args{4}), ...
           ['case,WRL,seed,converged,right,worst,distance,rayleigh,usedTolerance,', ...
            'usedError,runs'], [{strsplit(args{1}, ',')}, numbers], @oneCase);

% SPDX-License-Identifier: GPL-3.0-only
