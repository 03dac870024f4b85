% STOREDREPOSE  The stored runs of the template Repose, and what is asked of it.
%
% CALL: STORE = storedRepose (ROOT [, RIG])
%
%   ROOT   folder of the toolbox
%   RIG    '' (the template as it is) or 'Large': tube and plate 1.5 times as large,
%          grains 1.35 times, 2500 kg/m3, of other wall friction and restitution
%   STORE  struct data (see newData), problem (newProblem, limits of the template's
%          loadInput.m), variables (struct, modelVars of the rig)
%
% The 121 runs of results/reposeRuns.csv: decalioc new --model Repose,
% Input.numOfSam 120, decalioc run, decalioc export (2026-11-25); targets are those of
% the template. The 100 of reposeLargeRuns.csv were made so, too, with VARIABLES and
% numOfSam 100; the targets are near what these runs give at 0.45 and 0.12.
%
% See also: reposeSeeds

function store = storedRepose (root, rig)
  if nargin < 2
    rig = '';
  end
  values = {30.5, 0.012, 0.0173};
  variables = struct ('densityP', 1200);
  if strcmp (rig, 'Large')
    values = {31.1, 0.0871, 0.0264};
    variables = struct ('densityP', 2500, 'radiusP', 2.7e-3, 'tubeRadius', 0.0225, ...
                        'plateRadius', 0.048, 'filledSolid', 6.4e-5, ...
                        'liftHeight', 0.09, 'liftSpeed', 0.15, ...
                        'coefFrictionPW', 0.4, 'coefRestitutionPP', 0.5);
  end
  [header, cells] = readCsvTable (fullfile (root, 'benchmarks', 'results', ...
                                            ['repose', rig, 'Runs.csv']));
  read = @(names) str2double (cells(:, ismember (header, names)));
  names = {'coefFrictionPP', 'coefRollingFrictionPP'};
  results = header(end - 2:end);
  Case = struct ('names', {names}, 'limits', [0.2, 0.02; 0.8, 0.3]);
  Case.targets = struct ('name', results, 'value', values, ...
                         'tol', {0.06, 0.04, 0.08}, 'sd', 0, 'model', 1, ...
                         'role', {'calibrate', 'calibrate', 'holdout'});
  data = addRows (newData (2, 3), read (names), read (results), ...
                  ones (rows (cells), 1), 'plan');
  store = struct ('data', data, 'problem', newProblem (Case), 'variables', variables);
end

%!test
%! store = storedRepose (startBenchmarks ());
%! assert (size (store.data.Z), [121, 3]);
%! assert (all (isfinite (store.data.Z(:))));
%! large = storedRepose (startBenchmarks (), 'Large');
%! assert (size (large.data.Z), [100, 3]);
%! % the same forms, 1.5 times as large and twice as heavy
%! assert (mean (large.data.Z, 1) ./ mean (store.data.Z, 1), [1, 7.2, 1.5], -0.1);

% SPDX-License-Identifier: GPL-3.0-only
