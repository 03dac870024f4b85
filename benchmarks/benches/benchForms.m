% BENCHFORMS  Writes form.csv of the benches and of the template, of stored runs.
%
% CALL: benchForms ()
%       benchForms (FOLDER, NAMES, LIMITS, X, Z [, ISOTHER])
%
%   without arguments: DEMmodels/Collapse, Shear and Heap of examples/hiddenEffect (153
%   runs each), Drum and SlotBin of benchmarks/drumAndBins (159 and 147), the template of
%   benchmarks/results/reposeRuns.csv (121); with effects as further inputs
%
%   FOLDER  model folder with results.csv
%   NAMES   1 x d cellstr, parameters;  LIMITS  2 x d, the box of the runs
%   X, Z    n x d, n x T, runs of the model, results in the order of results.csv
%           (NaN: none)
%   ISOTHER n x 1 logical, runs that ended in another way, as in a slot that clogged: the
%           shape is of the others, and the columns other... say where these lie (none)
%
% A result that the runs say little of has no rows.
%
% See also: shapeOfRuns, knownShapes, storedShape

function benchForms (folder, names, limits, X, Z, isOther)
  if nargin == 5
    isOther = false (rows (X), 1);
  end
  if nargin > 0
    usual = Z;
    usual(isOther, :) = NaN;
    writeForm (folder, names, limits, X, usual, zeros (rows (X), 0), ...
               otherText (X, Z, isOther));
    return
  end
  root = startBenchmarks ();
  pkg ('load', 'stk');
  for store = {'hiddenEffect', 'drumAndBins'}
    [given, data] = storedCampaign (store{1}, root);
    problem = newProblem (given);
    phi = strengthOfValues (problem.effects, data.E);
    for k = 1:max (problem.bench)
      writeForm (fullfile (root, 'DEMmodels', problem.benchNames{k}), problem.names, ...
                 problem.limits, data.X, data.Z(:, problem.bench == k), phi, @(t, j) '');
    end
  end
  store = storedRepose (root);
  benchForms (fullfile (root, 'templates', 'model'), store.problem.names, ...
              store.problem.limits, store.data.X, store.data.Z);
end

% Handle text = ofRow (t, j), the last four columns of result t and parameter j: share of
% the runs in the box of those that ended otherwise, box, mean result over the usual one.
function ofRow = otherText (X, Z, isOther)
  ofRow = @(t, j) '';
  if any (isOther)
    box = [min(X(isOther, :), [], 1); max(X(isOther, :), [], 1)];
    inBox = all (X >= box(1, :) & X <= box(2, :), 2);
    share = sum (isOther) / sum (inBox);
    times = mean (Z(isOther, :), 1) ./ mean (Z(inBox & ~isOther, :), 1);
    ofRow = @(t, j) sprintf (',%.3g,%.4g,%.4g,%.3g', share, box(:, j), times(t));
  end
end

function writeForm (folder, names, limits, X, Z, phi, ofRow)
  info = resultInfo (folder);
  lines = {'result,parameter,low,high,slope,curvature,runs'};
  if ~isempty (ofRow (1, 1))
    lines{1} = [lines{1}, ',other,otherLow,otherHigh,otherTimes'];
  end
  for t = 1:numel (info)
    [C, Q2] = shapeOfRuns (X, Z(:, t), limits, phi);
    printf ('%s %s: Q2 %.2f\n', folder, info(t).name, Q2);
    for j = find (Q2 > 0.3 * ones (1, numel (names)))
      lines{end + 1} = sprintf ('%s,%s,%.4g,%.4g,%.3g,%.3g,%d%s', info(t).name, ...
                                names{j}, limits(1:2, j), C(j, :), ...
                                sum (isfinite (Z(:, t))), ofRow (t, j));
    end
  end
  writeAtomic (fullfile (folder, 'form.csv'), sprintf ('%s\n', lines{:}));
end

%!test
%! pkg load stk
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              "name,kind,unit,series,at,text\nangle,angle,deg,,,x\noff,mass,kg,,,x\n");
%! rand ('twister', 1);
%! randn ('twister', 1);
%! X = rand (40, 2) .* [2, 1];
%! Z = [20 + 3 * X(:, 1) + X(:, 2).^2, randn(40, 1)];
%! benchForms (folder, {'mu', 'rho'}, [0, 0; 2, 1], X, Z);
%! [header, cells] = readCsvTable (fullfile (folder, 'form.csv'));
%! assert (cells(:, 1:4), {'angle', 'mu', '0', '2'; 'angle', 'rho', '0', '1'});
%! assert (str2double (cells(:, 5:7)), [6, 0, 40; 0, 1, 40], 0.1);
%! assert (columns (header), 7);
%! isOther = X(:, 2) > 0.5 & rand (40, 1) < 0.4;
%! Z(isOther, 1) = 5;
%! benchForms (folder, {'mu', 'rho'}, [0, 0; 2, 1], X, Z, isOther);
%! [header, cells] = readCsvTable (fullfile (folder, 'form.csv'));
%! assert (str2double (cells(:, 5:7)), [6, 0, 40; 0, 1, 40] - sum (isOther) * [0, 0, 1], 0.1);
%! got = str2double (cells(:, 8:11));
%! assert (got(2, 2:3), [min(X(isOther, 2)), max(X(isOther, 2))], 1e-3);
%! assert (got(1, 1) > 0.2 && got(1, 1) < 0.8);
%! assert (got(1, 4), 0.21, 0.04);

% SPDX-License-Identifier: GPL-3.0-only
