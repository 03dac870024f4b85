% LEFTOUTFOLDER  A case whose measurement is a stored set of hiddenEffect.
%
% CALL: leftOutFolder (FOLDER, TRUTH, GIVEN, ROOT, BENCHES)
%
%   FOLDER   text, case folder to make
%   TRUTH    struct inputs (1 x n, design and effect variables of its rows in
%            storedRuns.csv), y (1 x T, what is measured)
%   GIVEN    of storedCampaign;  ROOT  text, folder of the toolbox
%   BENCHES  of the three of hiddenEffect the first so many: all other sets are its
%            runs.csv; a store beside FOLDER, no new run yet (Input.maxNewRuns)
%
% It is examples/hiddenEffect with nothing held out.
%
% See also: wholeRuns, setInput

function leftOutFolder (folder, truth, given, root, benches)
  source = fullfile (root, 'examples', 'hiddenEffect');
  [~, ~] = mkdir (folder);
  copyfile (fullfile (source, 'loadEffects.m'), folder);
  text = fileread (fullfile (source, 'loadInput.m'));
  writeAtomic (fullfile (folder, 'loadInput.m'), ...
               strrep (text, '''holdout''', '''calibrate'''));
  for b = 1:max (given.bench)
    setInput (folder, sprintf ('optim.targetVal{%d}', b), ...
              truth.y(given.bench == b));
  end
  giveRuns (folder, truth, given.benchNames(1:benches), source);
  onlyFirst (folder, benches);
  setInput (folder, 'Input.maxNewRuns', 0);
end

function giveRuns (folder, truth, names, source)
  table = fullfile (source, 'storedRuns.csv');
  [header, cells] = readCsvTable (table);
  inputs = str2double (cells(:, 3:find (strcmp (header, 'bulkDensity')) - 1));
  lines = strsplit (strtrim (fileread (table)), "\n");
  isTruth = all (toDigits (inputs) == toDigits (truth.inputs), 2);
  if ~any (isTruth)
    error ('leftOutFolder: no row of %s has the inputs of the truth', table);
  end
  kept = ismember (cells(:, 1), names) & ~isTruth;
  lines = lines([true; kept]);
  writeAtomic (fullfile (folder, 'runs.csv'), [strjoin(lines, "\n"), "\n"]);
end

function onlyFirst (folder, n)
  file = fullfile (folder, 'loadInput.m');
  lines = {sprintf('  Input.store = ''%s'';', fullfile (fileparts (folder), ...
                                                        'store')), ...
           sprintf('  Input.model = Input.model(1:%d);', n), ...
           sprintf('  Input.cpu = Input.cpu(1:%d);', n), ...
           '  for name = fieldnames (optim)''', ...
           sprintf('    optim.(name{1}) = optim.(name{1})(1:%d);', n), ...
           '  end', '  modelVars.readTime'};
  writeAtomic (file, strrep (fileread (file), lines{end}, ...
                             strjoin (lines, "\n")));
end

%!test
%! root = startBenchmarks ();
%! pkg ('load', 'stk');
%! [given, data] = storedCampaign ('hiddenEffect', root);
%! folder = fullfile (tempname (), '5');
%! truth = struct ('inputs', [data.X(5, :), data.E(5, :)], 'y', 1:14);
%! leftOutFolder (folder, truth, given, root, 2);
%! before = cd (folder);
%! back = onCleanup (@() cd (before));
%! clear ('-f', 'loadInput', 'loadEffects');
%! Case = loadCase (root, folder);
%! assert ([Case.targets.value], 1:10);
%! assert (all (strcmp ({Case.targets.role}, 'calibrate')));
%! assert ({Case.models.name}, {'Collapse', 'Shear'});
%! Case = withEffects (Case);
%! data = importRuns (fullfile (folder, 'runs.csv'), Case);
%! assert (rows (data.Z), 152);
%! assert (all (isfinite (data.Z(:))));
%! clear ('-f', 'loadInput', 'loadEffects');

% SPDX-License-Identifier: GPL-3.0-only
