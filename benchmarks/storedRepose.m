% STOREDREPOSE  The stored runs of the template Repose, and what is asked of it.
%
% CALL: STORE = storedRepose (ROOT)
%
%   ROOT   folder of the toolbox
%   STORE  struct data (see newData), problem (newProblem, targets and limits of
%          the template's loadInput.m)
%
% The 121 runs of results/reposeRuns.csv: decalioc new --model Repose,
% Input.numOfSam 120, decalioc run, decalioc export (2026-11-25).
%
% See also: reposeSeeds

function store = storedRepose (root)
  [header, cells] = readCsvTable (fullfile (root, 'benchmarks', 'results', ...
                                            'reposeRuns.csv'));
  values = @(names) str2double (cells(:, ismember (header, names)));
  names = {'coefFrictionPP', 'coefRollingFrictionPP'};
  results = header(end - 2:end);
  Case = struct ('names', {names}, 'limits', [0.2, 0.02; 0.8, 0.3]);
  Case.targets = struct ('name', results, 'value', {30.5, 0.012, 0.0173}, ...
                         'tol', {0.06, 0.04, 0.08}, 'sd', 0, 'model', 1, ...
                         'role', {'calibrate', 'calibrate', 'holdout'});
  data = addRows (newData (2, 3), values (names), values (results), ...
                  ones (rows (cells), 1), 'plan');
  store = struct ('data', data, 'problem', newProblem (Case));
end

%!test
%! store = storedRepose (startBenchmarks ());
%! assert (size (store.data.Z), [121, 3]);
%! assert (all (isfinite (store.data.Z(:))));

% SPDX-License-Identifier: GPL-3.0-only
