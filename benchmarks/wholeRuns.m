% WHOLERUNS  Whole diagnoses on LIGGGHTS from stored runs, and the next test.
%
% CALL: octave-cli benchmarks/wholeRuns.m ROWS WORK CSV [BENCHES]
%
%   ROWS     rows of the stored campaign examples/hiddenEffect, e.g. 31,69
%   WORK     folder of the cases (WORK/ROW), kept; a case that lies there goes on
%   CSV      table, to which one row a case is added; cases that stand in it are
%            not made again
%   BENCHES  how many of the case's benches, collapse, shear cell, heap, it has
%            (3); d in the table is that of all three
%
% The measurement is the row of storedRuns.csv with the reading errors that
% leftOut draws for it, so leftOut-hiddenEffect.csv holds the verdict on the
% same numbers from the 152 other sets of that fixed plan. The case is
% examples/hiddenEffect with nothing held out, which begins with these sets
% (runs.csv) and is diagnosed by bin/decalioc; all share the runs of WORK/store.
% What is withheld without a new run goes on to the next test. sets, newRuns and
% coreMinutes: of the effects and of those that verify.
%
% Where the verdict leaves open which kind of cause it is (group or undecided,
% but for a look-alike that nobody listed), the advised test, if it tells 0.2
% bit, is measured: three trials, each a run of the truth with another packing
% and a reading error; its table is filled in, as a user does it, and the
% diagnosis started again. Beside it, in a copy of the case, the bench that
% tells most of those measured already, once more. Right is a name of the true
% cause, or a verdict that it is this one or something that looks like it.
% "Once more" has no new runs: none that verify could take a name away.
%
% See also: leftOut, planStudy

1;

function runStudy (numbers, work, file, benches)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  pkg ('load', 'stk');
  [given, data] = storedCampaign ('hiddenEffect', root);
  study = struct ('work', work, 'root', root);
  fillTable (file, ['row,truth,strength,d,fixedPlan,said,sets,newRuns,coreMinutes,', ...
                    'minutes,test,gain,between,after,runsAfter,right,wrong,', ...
                    'onceBench,onceGain,once,onceRight,onceWrong'], {numbers}, ...
             @(number) oneCase (number, given, data, study, benches));
end

function cells = oneCase (number, given, data, study, benches)
  [work, root] = deal (study.work, study.root);
  truth = truthOf (number, given, data, root);
  folder = fullfile (work, sprintf ('%d', number));
  if ~isfile (fullfile (folder, 'loadInput.m'))
    leftOutFolder (folder, truth, given, root, benches);
  end
  start = time ();
  first = diagnosed (folder, root);
  if isOpenCase (first, truth)
    setInput (folder, 'Input.maxNewRuns', 600);
    first = diagnosed (folder, root);
  end
  minutes = (time () - start) / 60;
  spent = first.demRuns;
  cells = [truth.cells, ...
           {said(first), spent.sets, spent.new, ...
            spent.coreSeconds / 60, minutes}];
  if ~isOpenCase (first, truth)
    cells(10:21) = {'not withheld', '', '', '', '', '', '', '', '', '', '', ''};
  else
    cells = [cells, withheld(first, truth, folder, root)];
  end
end

function is = isOpenCase (g, truth)
  [~, is] = testOutcome (g.which, truth.cause);
end

% The set that is left out: values of all variables, measured values, and what
% the fixed plan said of them.
function truth = truthOf (number, given, data, root)
  values = [data.X(number, :), data.E(number, :)];
  phi = strengthOfValues (newProblem (given).effects, data.E(number, :));
  dem = given.effects(~[given.effects.laboratory]);
  names = [given.names(:)', [dem.variables]];
  noise = integrationPoints (1, columns (data.Z), 8000 + number).normal;
  [header, cells] = readCsvTable (fullfile (root, 'benchmarks', 'results', ...
                                            'leftOut-hiddenEffect.csv'));
  own = cells(strcmp (cells(:, 2), sprintf ('%d', number)), :);
  of = @(name) own{strcmp(header, name)};
  truth = struct ('number', number, 'values', ...
                  cell2struct (num2cell (values(:)), names(:), 1), 'cause', ...
                  of ('cause'), 'y', data.Z(number, :) + given.sd .* noise, ...
                  'inputs', values);
  truth.values.readTime = 0.4;      % of the shear cell, see its loadInput.m
  truth.cells = {of('cause'), phi(phi ~= 0), str2double(of ('d')), ...
                 [of('verdict'), ':', of('effects')]};
end

function g = diagnosed (folder, root)
  status = system (sprintf ('%s diagnose %s >> %s 2>&1 < /dev/null', ...
                            fullfile (root, 'bin', 'decalioc'), folder, ...
                            fullfile (folder, 'said.txt')));
  if ~any (status == [0, 2])
    error ('wholeRuns: decalioc diagnose %s ended with %d, see said.txt', ...
           folder, status);
  end
  g = readJsonFile (fullfile (folder, 'gap', 'gap.json'));
end

function text = said (g)
  text = [g.which.verdict, ':', strjoin(cellstr (g.which.effects)', '+')];
  if strcmp (g.which.verdict, 'named') && g.which.lookAlike
    text = [text, ' or alike'];
  end
end

function cells = withheld (first, truth, folder, root)
  tests = arrayfun (@(k) jsonAt (first.next, {k}), 1:numel (first.next), ...
                    'UniformOutput', false);
  runs = cellfun (@(t) t.runs, tests);
  best = tests{1};
  once = tests{find(runs == 0, 1)};
  again = onceMore (once, truth, folder, root);
  after = first;
  if best.gain >= gapOptions ([]).adviseAt
    after = again;
    if best.runs > 0
      copy = [folder, '-next'];
      copyCase (folder, copy);
      randn ('twister', 8000 + truth.number);
      fillTest (fullfile (copy, 'gap', 'next'), best.model, truth.values);
      after = diagnosed (copy, root);
    elseif ~strcmp (best.test, once.test)
      after = onceMore (best, truth, folder, root);
    end
  end
  cells = [{best.test, best.gain, strjoin(cellstr (best.between)', ' or '), ...
            said(after), after.demRuns.new}, ...
           testOutcome(after.which, truth.cause), ...
           {once.model, once.gain, said(again)}, ...
           testOutcome(again.which, truth.cause)];
end

function copyCase (folder, copy)
  if ~isfolder (copy)
    system (sprintf ('cp -r %s %s', folder, copy));
  end
end

% The same bench again, another packing: the mean of both.
function g = onceMore (test, truth, folder, root)
  copy = [folder, '-', test.model];
  copyCase (folder, copy);
  given = storedCampaign ('hiddenEffect', root);
  b = find (strcmp (given.benchNames, test.model));
  own = given.bench == b;
  y = truth.y;
  bench = fullfile (root, 'DEMmodels', test.model);
  z = truthRuns (bench, truth.values, 1, fullfile (copy, 'gap', 'truth'));
  randn ('twister', 9000 + truth.number);
  y(own) = (y(own) + z + given.sd(own) .* randn (1, sum (own))) / 2;
  setInput (copy, sprintf ('optim.targetVal{%d}', b), y(own));
  setInput (copy, sprintf ('optim.targetStd{%d}', b), given.sd(own) / sqrt (2));
  setInput (copy, sprintf ('optim.trials{%d}', b), 2 * ones (1, sum (own)));
  setInput (copy, 'Input.maxNewRuns', 0);
  g = diagnosed (copy, root);
end

% CELLS, 0 or 1: named rightly, named wrongly, by a verdict (WHICH of gap.json); that it is
% this one or something that looks like it counts as a name. ISOPEN: group or undecided.
function [cells, isOpen] = testOutcome (which, truth)
  isAlike = strcmp (which.guard, 'look-alike');
  isOpen = any (strcmp (which.verdict, {'group', 'undecided'})) && ~isAlike;
  isName = strcmp (which.verdict, 'named') || ...
           (strcmp (which.verdict, 'group') && isAlike);
  isTrue = isequal (cellstr (which.effects), {truth});
  cells = {double(isName && isTrue), double(isName && ~isTrue)};
end

% The table of an advised test is filled in, as a user does who measures: each trial is a
% run with a packing of its own and a reading error of the sd in the table, or of the
% scatter of the bench's results, which is filled in then.
function fillTest (place, model, values)
  folder = fullfile (place, 'DEMmodels', model);
  if ~isfolder (folder)
    root = fileparts (fileparts (which ('startToolbox')));
    folder = fullfile (root, 'DEMmodels', model);
  end
  names = {resultInfo(folder).name};
  scatter = scatterOf (folder, names);
  file = fullfile (place, [model, '.csv']);
  lines = strsplit (strtrim (fileread (file)), "\n");
  Y = truthRuns (folder, values, 3, fullfile (fileparts (place), ...
                                              ['truth-', model]));
  trial = zeros (size (names));
  for i = 5:numel (lines)
    fields = ostrsplit (lines{i}, ',');
    at = find (strcmp (names, [fields{2}, repmat(fields{3}, 1, ...
                                                 isempty (fields{2}))]), 1);
    trial(at) = trial(at) + 1;
    sd = str2double (fields{6});
    if isnan (sd)
      sd = scatter(at);
    end
    fields{5} = sprintf ('%.8g', Y(trial(at), at) + sd * randn ());
    fields{6} = sprintf ('%.4g', sd);
    lines{i} = strjoin (fields, ',');
  end
  writeAtomic (file, [strjoin(lines, "\n"), "\n"]);
end

% N trials (at most 4) of the bench in folder MODEL, as the laboratory would: VALUES is what
% the material is, of which those that its data.head declares are set; the packings are
% seeds 5 to 8 of benchSeeds, which no case draws. STEM: path of the runs; finished ones
% are reused. Y (N x m): see the bench's results.csv.
function Y = truthRuns (model, values, n, stem)
  known = fieldnames (headDefaults (fullfile (model, 'data.head')));
  values = rmfield (values, setdiff (fieldnames (values), known));
  Y = [];
  for trial = 1:n
    values.runSeed = benchSeeds (4 + trial);
    Y = [Y; benchRun(sprintf ('%s-%d', stem, trial), model, values)];
  end
end

function sd = scatterOf (folder, names)
  sd = NaN (size (names));
  file = fullfile (folder, 'scatter.csv');
  if isfile (file)
    sd = runScatter (folder);
  end
end

args = argv ();
benches = 3;
if numel (args) > 3
  benches = str2double (args{4});
end
runStudy (str2num (['[', args{1}, ']']), make_absolute_filename (args{2}), ...
          make_absolute_filename (args{3}), benches);

% SPDX-License-Identifier: GPL-3.0-only
