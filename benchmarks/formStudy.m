% FORMSTUDY  Diagnoses stored cases whose causes have another form than any law.
%
% CALL: octave-cli benchmarks/formStudy.m CSV STEP [PARTS] [FOLDER] [CASES]
%
%   CSV     file to write, one row a case; its figures are printed
%   STEP    every STEP-th row of a campaign, every STEP-th case of a study
%   PARTS   letters: h left-out runs of hiddenEffect, d of drumAndBins, s sealed
%           cases of the former, b of the latter, c changes (default hdsbc)
%   FOLDER  keeps fitted surrogates and what the gate compares with, for a second
%           call of the same code
%   CASES   of the sealed ones, a space between: classes, or numbers, as in
%           results/blind-truth.csv (default: all)
%
% No new run of DEM. Left-out runs of hiddenEffect and drumAndBins, the sealed
% cases of both (results/blind-*, blindbins-*: drawn from numbers that nobody knew,
% run with laws that the library does not have), and changes from a reference: a
% left-out run beside one of the same parameters without an effect
% (results/changePairs.csv), where sliding, wall and rolling friction are
% candidates too (formChange). Each case with one listed cause of d >= 3 is
% given three times: as it is, and with what the cause makes turned by a tangent
% of 0.35 and 0.6, in turns towards another listed effect and along benches and
% curves (formCase). Integrals are coarser than those of a diagnosis (effective
% size 150), and what the gate compares with is drawn once for each campaign.
%
% See also: gapTables, formCase, leftOut

1;

% Study with surrogates of which DATA are known, kept in FOLDER under NAME.
function emulator = emulatorOf (name, folder, problem, data, options, old)
  file = fullfile (folder, [name, '.mat']);
  if ~isempty (folder) && exist (file, 'file') == 2
    emulator = load (file).emulator;
    return
  end
  emulator = fitEmulator (problem, data, options, old{:});
  if ~isempty (folder)
    save ('-binary', file, 'emulator');
  end
end

% What the gate compares with, for the CASES of one campaign.
function how = withReference (how, name, problem, emulator)
  file = fullfile (how.folder, [name, '-reference.mat']);
  if ~isempty (how.folder) && exist (file, 'file') == 2
    how.reference = load (file).reference;
    return
  end
  emulator = emulateChange (emulator, problem);
  hypotheses = makeHypotheses (problem, emulator, how.options, ...
                               find (isfinite (problem.value)));
  reference = gapReference (hypotheses).reference;
  how.reference = reference;
  if ~isempty (how.folder)
    save ('-binary', file, 'reference');
  end
end

function list = leftOutCases (name, root, step, how)
  [given, data] = storedCampaign (name, root);
  given.held(:) = false;
  problem = newProblem (given);
  whole = emulatorOf (name, how.folder, problem, data, how.options, {});
  how = withReference (how, name, problem, whole);
  inputs = [data.X, data.E];
  list = {};
  numbers = find (all (isfinite (data.Z), 2))';
  for i = numbers(1:step:end)
    own = given;
    noise = integrationPoints (1, columns (data.Z), 8000 + i).normal;
    own.value = data.Z(i, :) + given.sd .* noise;
    rest = keepRows (data, ~all (inputs == inputs(i, :), 2));
    emulator = emulatorOf (sprintf ('%s-%d', name, i), how.folder, problem, ...
                           rest, how.options, {whole});
    truth = struct ('X', data.X(i, :), 'phi', ...
                    strengthOfValues (problem.effects, data.E(i, :)));
    list = [list, formCase(name, i, own, emulator, truth, how)];
  end
end

function list = sealedCases (stem, name, root, step, how)
  [given, data] = storedCampaign (name, root);
  if strcmp (stem, 'blind')
    home = cd (fullfile (root, 'examples', name));
    Case = withEffects (loadCase (root, pwd ()));
    data = importRuns (fullfile (root, 'benchmarks', 'form', 'sealedRuns.csv'), Case);
    cd (home);
  end
  problem = newProblem (given);
  whole = emulatorOf (stem, how.folder, problem, data, how.options, {});
  table = @(what) tableRows (fullfile (root, 'benchmarks', 'results', ...
                                       [stem, '-', what, '.csv']));
  [truths, values] = deal (table ('truth'), table ('cases'));
  first = withValues (given, values(strcmp ({values.case}, truths(1).case)));
  how = withReference (how, stem, newProblem (first), whole);
  list = {};
  if ~isempty (how.cases)
    truths = truths(ismember ({truths.class}, how.cases) | ...
                    ismember ({truths.case}, how.cases));
  end
  for t = truths(1:step:end)
    own = withValues (given, values(strcmp ({values.case}, t.case)));
    off = find (strcmp ({whole.effect.name}, t.removed));
    truth = struct ('X', cellfun (@(n) str2double (t.(n)), given.names), ...
                    'phi', zeros (1, numel (given.effects)));
    causes = strsplit (t.cause, ' ');
    [isThere, at] = ismember (causes, {given.effects.name});
    strengths = str2double (strsplit (t.phi, ' '));
    truth.phi(at(isThere)) = strengths(isThere);
    truth.isUnlisted = strcmp (t.class, 'unlisted') || ~isempty (off);
    own.effects(off) = [];
    truth.phi(off) = [];
    list = [list, formCase(stem, str2double (t.case), own, ...
                           withoutEffects(whole, off), truth, how)];
  end
end

function given = withValues (given, lines)
  given.value(:) = NaN;
  given.held(:) = false;
  for one = lines
    bench = find (strcmp (given.benchNames, one.model));
    t = find (strcmp (given.targetNames, one.name) & given.bench == bench);
    given.value(t) = str2double (one.value);
    given.sd(t) = str2double (one.sd);
    given.held(t) = strcmp (one.role, 'holdout');
  end
  given.trials = str2double (lines(1).repeats);
end

function list = changeCases (root, step, how)
  [given, data, pairs] = formChange (root);
  problem = newProblem (given);
  phi = strengthOfValues (problem.effects, data.E);
  isWhole = all (isfinite (data.Z), 2) & ismember (data.X, pairs.X, 'rows') & ...
            ~any (phi(:, end - 2:end), 2);
  whole = emulatorOf ('change', how.folder, problem, data, how.options, {});
  list = {};
  numbers = find (isWhole)';
  for i = numbers(1:step:end)
    noise = integrationPoints (2, columns (data.Z), 9000 + i).normal;
    j = find (ismember (pairs.X, data.X(i, :), 'rows'), 1);
    own = given;
    own.value = data.Z(i, :) + given.sd .* noise(1, :);
    own.reference = struct ('value', pairs.Z(j, :) + given.sd .* noise(2, :), ...
                            'sd', given.sd, 'trials', problem.trials, ...
                            'scatter', problem.scatter, 'perCondition', ...
                            false (1, columns (data.X)));
    if isempty (list)
      how = withReference (how, 'change', newProblem (own), whole);
    end
    isSame = all ([data.X, data.E] == [data.X(i, :), data.E(i, :)], 2);
    emulator = emulatorOf (sprintf ('change-%d', i), how.folder, problem, ...
                           keepRows (data, ~isSame), how.options, {whole});
    truth = struct ('X', data.X(i, :), 'phi', phi(i, :));
    list = [list, formCase('change', i, own, emulator, truth, how)];
  end
end

addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
words = argv ();
[words{end + 1:5}] = deal ('');
if isempty (words{3})
  words{3} = 'hdsbc';
end
how = struct ('folder', words{4}, 'cases', ...
              {strsplit(words{5}, ' ')(1:end * ~isempty (words{5}))}, ...
              'options', ...
              gapOptions (struct ('points', 300, 'effective', 150, 'most', ...
                                  3000, 'leastPoints', 75)));
step = str2double (words{2});
of = struct ('h', @() leftOutCases ('hiddenEffect', root, step, how), ...
             'd', @() leftOutCases ('drumAndBins', root, step, how), ...
             's', @() sealedCases ('blind', 'hiddenEffect', root, step, how), ...
             'b', @() sealedCases ('blindbins', 'drumAndBins', root, step, ...
                                   how), ...
             'c', @() changeCases (root, step, how));
cases = {};
for part = words{3}
  cases = [cases, of.(part)()];
end
writeTable (words{1}, [{formCase()}, cases]);
printf ('Figures: octave-cli benchmarks/figures.m show form %s\n', words{1});

% SPDX-License-Identifier: GPL-3.0-only
