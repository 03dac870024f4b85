% FUZZCALIBRATIONS  Calibrates random formulas and reports what goes wrong.
%
% CALL: [FAILURES, COUNT] = fuzzCalibrations (SEEDS)
%
%   SEEDS     1 x n integers, one problem each
%   FAILURES  1 x m cell of texts, one a failure, with its seed
%   COUNT     struct: calibrations, refused (errors of DEcalioc, where due),
%             converged, wrong (of these, with a true response beyond twice its
%             tolerance), close (pairs of which one converged and whose sets are
%             the same)
%
% 1 to 8 parameters, 1 to 40 targets; runs that fail, responses that nothing
% moves, targets that are the same or out of reach, simulations without noise,
% absolute tolerances, targets held out, parameters measured by themselves. Each
% is calibrated in two writings: in random units (1e-12 to 1e12, of every target
% and parameter), and in others, with other names or the rows of the plan in
% another order. A failure is an error that is none of DEcalioc or is not due, a
% warning, a number that is NaN or out of bounds where it may not be, and
% another set (by more than 1 % of the box; with fewer targets than parameters
% many sets are as good: by more than a tolerance of a response). Rows in another
% order move the next run by the last digits of a flat optimum, and a run that is
% moved draws another scatter: where neither set is confirmed, each has to be one
% that the other calibration holds for possible.
%
% See also: fuzzSeeds, fuzzDiagnoses, calibrateStandIn

function [failures, count] = fuzzCalibrations (seeds)
  count = struct ('calibrations', 0, 'refused', 0, 'converged', 0, ...
                  'wrong', 0, 'close', 0);
  [failures, count] = fuzzSeeds ('fuzzCalibrations', seeds, @tryOne, count);
end

function [found, count] = tryOne (seed, count)
  lab = drawn (seed);
  [first, found] = calibrated (lab, {'units'}, seed);
  count = counted (count, first, lab);
  if isempty (first) || ~isempty (found)
    return
  end
  ways = {{'units'}, {'units', 'names'}, {'rows'}, {'units', 'rows'}};
  how = ways{1 + mod(seed, 4)};
  [other, found] = calibrated (lab, how, seed + 1e6);
  count = counted (count, other, lab);
  if isempty (other) || ~isempty (found)
    return
  end
  [text, isClose] = compared (first, other, lab, how);
  count.close = count.close + isClose;
  if ~isempty (text)
    found = {sprintf('%s changes the result: %s', strjoin (how, ', '), text)};
  end
end

function lab = drawn (seed)
  rand ('twister', seed);
  randn ('twister', seed);
  few = @(most) 1 + floor (most * rand ()^3);
  chance = @(p) rand () < p;
  d = few (8);
  T = few (6);
  if chance (0.05)
    T = few (40);
  end
  lab.slope = randn (d, T);
  lab.bent = 0.3 * randn (d, T);
  if chance (0.15)
    [lab.slope(:, 1), lab.bent(:, 1)] = deal (0);          % nothing moves it
  end
  if T > 1 && chance (0.15)
    [lab.slope(:, 2), lab.bent(:, 2)] = deal (lab.slope(:, 1), lab.bent(:, 1));
  end
  lab.noise = (chance (0.8)) * 0.02 * rand ();
  lab.fail = 0.2 * rand () * chance (0.2);
  lab.base = 5;
  if chance (0.05)
    lab.base = 0;                                          % responses near 0
  end
  value = meansOf (lab, 0.1 + 0.8 * rand (1, d)) .* ...
          (1 + 0.3 * randn (1, T) .* chance (0.1));
  tol = 0.005 + 0.03 * rand (1, T);
  isAbsolute = rand (1, T) < 0.2 | value == 0;
  lab.targets = struct ('name', '', 'value', num2cell (value), ...
                        'tol', num2cell (tol), 'sd', 0, ...
                        'role', 'calibrate', ...
                        'isAbsolute', num2cell (isAbsolute));
  if T > 2 && chance (0.2)
    lab.targets(T).role = 'holdout';
  end
  [lab.paramMean, lab.paramSd] = deal (NaN (1, d));
  if chance (0.2)
    [lab.paramMean(1), lab.paramSd(1)] = deal (0.5, 0.1);
  end
  lab.options = struct ('sets', 1 + floor (3 * rand ()), 'seed', seed, ...
                        'maxFunEvals', 12);
  lab.X = rand (d + 5 + floor (rand () * 3 * d), d);
end

function Z = meansOf (lab, X)
  Z = lab.base + X * lab.slope + (X - 0.5).^2 * lab.bent;
end

% Scatter and failures that only depend on the set and its replicate.
function Z = runsOf (lab, X, replicate)
  replicate = replicate .* ones (rows (X), 1);
  key = round (1e6 * [X, replicate]) * (1:columns (X) + 1)';
  u = mod (sin (key * (1:columns (lab.slope) + 1)) * 43758.5453, 1);
  Z = meansOf (lab, X) + lab.noise * (u(:, 2:end) - 0.5) * sqrt (12);
  Z(u(:, 1) < lab.fail, :) = NaN;
end

% The calibration of DEcalioc, on a formula.
function [r, found] = calibrated (lab, how, seed)
  [r, found] = deal ([], {});
  [Case, X, unit, width] = written (lab, how, seed);
  rand ('twister', 1);
  randn ('twister', 1);
  lastwarn ('', '');
  n = rows (X);
  evaluate = @(P, E, replicate) ...
    runsOf (lab, P ./ width, replicate) .* unit;
  try
    problem = newProblem (Case, []);
    data = addRows (newData (columns (X), numel (unit)), X, ...
                    evaluate (X, [], 1), ones (n, 1), 'plan');
    surrogates = fitSurrogates (data, problem);
    state = newState (data, surrogates, ...
                      calibrateOnKriging (surrogates, problem));
    state.evaluate = newEvaluate (evaluate);
    state = improveByInfill (state, problem, @(text) []);
    state = calibrateOnDEM (state, problem, @(text) []);
    known = parameterPosterior (state.surrogates, problem);
  catch err
    if strncmp (err.identifier, 'DEcalioc:', 9) && lab.fail > 0
      r = struct ('refused', true);
      return
    end
    at = '';
    if ~isempty (err.stack)
      at = sprintf (' (%s, %d)', err.stack(1).name, err.stack(1).line);
    end
    found = {['throws ', err.identifier, ': ', err.message, at]};
    return
  end
  if ~isempty (lastwarn ())
    found = {['warns: ', lastwarn()]};
  end
  r = struct ('params', state.final.params ./ width, ...
              'converged', state.final.converged, ...
              'probability', state.final.probability, ...
              'interval', known.interval90 ./ width);
  found = [found, wrongNumbers(r)];
end

function [Case, X, unit, width] = written (lab, how, seed)
  rand ('twister', seed);
  T = columns (lab.slope);
  d = columns (lab.X);
  [unit, width, back] = deal (ones (1, T), ones (1, d), 1:rows (lab.X));
  letter = 'y';
  if any (strcmp (how, 'units'))
    unit = 10.^(24 * rand (1, T) - 12);
    width = toDigits (10.^(24 * rand (1, d) - 12));      % as checkBox rounds limits
  end
  if any (strcmp (how, 'names'))
    letter = 'another ';
  end
  if any (strcmp (how, 'rows'))
    back = randperm (rows (lab.X));
  end
  X = lab.X(back, :) .* width;
  Case = struct ('limits', [zeros(1, d); width], 'targets', lab.targets, ...
                 'options', lab.options, ...
                 'paramMean', lab.paramMean .* width, ...
                 'paramSd', lab.paramSd .* width);
  Case.names = arrayfun (@(j) sprintf ('p%d', j), 1:d, 'UniformOutput', false);
  for t = 1:T
    own = Case.targets(t);
    Case.targets(t).name = sprintf ('%s%d', letter, t);
    Case.targets(t).value = own.value * unit(t);
    if own.isAbsolute
      Case.targets(t).tol = own.tol * 5 * unit(t);
    end
  end
end

function found = wrongNumbers (r)
  found = {};
  if ~all (isfinite (r.params)) || ~all (abs (r.params - 0.5) <= 0.5 + 1e-9)
    found{end + 1} = 'a set outside the box';
  end
  if ~(r.probability >= 0 && r.probability <= 1)
    found{end + 1} = 'a probability that is none';
  end
  if ~all (diff (r.interval) >= 0) || ~all (isfinite (r.interval(:)))
    found{end + 1} = 'an interval that is none';
  end
end

function [text, isClose] = compared (a, b, lab, how)
  [text, isClose] = deal ('', false);
  if isfield (a, 'refused') || isfield (b, 'refused')
    if ~(isfield (a, 'refused') && isfield (b, 'refused'))
      text = 'one of the two is refused';
    end
    return
  end
  off = max (abs (a.params - b.params));
  [half, own] = tolerances (lab);
  if sum (own) < numel (a.params)
    apart = abs (meansOf (lab, a.params) - meansOf (lab, b.params)) ./ half;
    off = min (off, 0.01 * max (apart(own)));
  end
  if any (strcmp (how, 'rows')) && ~a.converged && ~b.converged
    off = min (off, max (beyond (a.params, b.interval), ...
                         beyond (b.params, a.interval)));
  end
  isClose = a.converged ~= b.converged && off <= 0.01;
  if off > 0.01
    words = {'not converged', 'converged'};
    text = sprintf ('%s and %s, sets differ by %.3g of the box', ...
                    words{1 + a.converged}, words{1 + b.converged}, off);
  end
end

% How far a set lies outside intervals (2 x d), in parts of the box.
function off = beyond (params, interval)
  off = max ([interval(1, :) - params, params - interval(2, :), 0]);
end

function count = counted (count, r, lab)
  count.calibrations = count.calibrations + 1;
  if isempty (r)
    return
  end
  if isfield (r, 'refused')
    count.refused = count.refused + 1;
    return
  end
  count.converged = count.converged + r.converged;
  [half, own] = tolerances (lab);
  off = abs (meansOf (lab, r.params) - [lab.targets.value]) ./ half;
  count.wrong = count.wrong + (r.converged && any (off(own) > 2));
end

% Of each response, and which ones are fitted.
function [half, own] = tolerances (lab)
  half = [lab.targets.tol] .* abs ([lab.targets.value]);
  isAbsolute = [lab.targets.isAbsolute];
  half(isAbsolute) = [lab.targets(isAbsolute).tol] * 5;
  own = strcmp ({lab.targets.role}, 'calibrate');
end

% SPDX-License-Identifier: GPL-3.0-only
