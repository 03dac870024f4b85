% WHOLERUNS  Whole diagnoses on LIGGGHTS from an empty store, next tests too.
%
% CALL: octave-cli benchmarks/wholeRuns.m ROWS WORK CSV
%       octave-cli benchmarks/wholeRuns.m ROWS WORK CSV plan
%
%   ROWS  rows of the stored campaign examples/hiddenEffect, e.g. 31,69
%   WORK  folder of the cases (WORK/ROW), kept; a case that lies there goes on
%   CSV   table, to which one row a case is added; cases that stand in it are
%         not made again
%
% The measurement is the row of storedRuns.csv with the reading errors that
% leftOut draws for it, so leftOut-hiddenEffect.csv holds the verdict on the
% same numbers from the 152 other sets of that fixed plan. The case is
% examples/hiddenEffect with nothing held out, diagnosed by bin/decalioc; of the
% runs of an earlier case in WORK it takes the neutral plan, which is the same
% for all. Sets are those of the plan, of the effects and those that verify;
% newRuns, coreMinutes and minutes do not hold a plan that was taken.
%
% Where the verdict leaves open which kind of cause it is (group or undecided,
% but for a look-alike that nobody listed), the advised test, if it tells 0.2
% bit, is measured: three trials, each a run of the truth with another packing
% and a reading error; its table is filled in, as a user does it, and the
% diagnosis started again. Beside it, in a copy of the case, the bench that
% tells most of those measured already, once more. Right is a name of the true
% cause, or a verdict that it is this one or something that looks like it.
%
% With the word plan no next test is sought: the toolbox is copied to
% WORK/toolbox, without the files that say what an experimenter can change.
%
% See also: fillTest, leftOut, nextTestStudy, planStudy

1;

function runStudy (numbers, work, file, isPlan)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  if isPlan
    root = withoutSettings (root, fullfile (work, 'toolbox'));
  end
  pkg ('load', 'stk');
  if ~isfile (file)
    appendLine (file, ['row,truth,strength,d,fixedPlan,said,sets,newRuns,', ...
                       'coreMinutes,minutes,test,gain,between,after,', ...
                       'runsAfter,right,wrong,onceBench,onceGain,once,', ...
                       'onceRight,onceWrong']);
  end
  done = str2double (regexp (fileread (file), '^\d+', 'match', 'lineanchors'));
  [given, data] = storedCampaign ('hiddenEffect', root);
  for number = setdiff (numbers, done, 'stable')
    appendLine (file, oneCase (number, given, data, work, root, isPlan));
  end
end

function to = withoutSettings (root, to)
  if ~isfolder (to)
    [~, ~] = mkdir (fileparts (to));
    system (sprintf (['git -C %s archive --prefix=toolbox/ HEAD | ', ...
                      'tar -x -C %s'], root, fileparts (to)));
    system (sprintf (['rm -f %s/DEMmodels/*/settings.csv ', ...
                      '%s/DEMmodels/*/scatter.csv'], to, to));
  end
end

function line = oneCase (number, given, data, work, root, isPlan)
  truth = truthOf (number, given, data, root);
  folder = fullfile (work, sprintf ('%d', number));
  if ~isfile (fullfile (folder, 'loadInput.m'))
    makeCase (folder, truth, given, root);
    takePlan (folder, work, given);
  end
  start = time ();
  first = diagnosed (folder, root);
  minutes = (time () - start) / 60;
  spent = first.demRuns;
  plan = 30;                            % its neutral sets, Input.numOfSam
  cells = [{number}, truth.cells, ...
           {said(first), plan + spent.sets, spent.new, ...
            spent.coreSeconds / 60, minutes}];
  [~, isOpen] = testOutcome (first.which, truth.cause);
  if isPlan
    cells(11:22) = {'not sought', '', '', '', '', '', '', '', '', '', '', ''};
  elseif ~isOpen
    cells(11:22) = {'not withheld', '', '', '', '', '', '', '', '', '', '', ''};
  else
    cells = [cells, withheld(first, truth, folder, root)];
  end
  line = rowText (cells);
end

% The set that is left out: values of all variables, measured values, and what
% the fixed plan said of them.
function truth = truthOf (number, given, data, root)
  values = [data.X(number, :), data.E(number, :)];
  phi = strengthOfValues (newGapProblem (given).effects, data.E(number, :));
  dem = given.effects(~[given.effects.laboratory]);
  names = [given.names(:)', [dem.variables]];
  noise = integrationPoints (1, columns (data.Z), 8000 + number).normal;
  [header, cells] = readCsvTable (fullfile (root, 'benchmarks', 'results', ...
                                            'leftOut-hiddenEffect.csv'));
  own = cells(strcmp (cells(:, 2), sprintf ('%d', number)), :);
  of = @(name) own{strcmp(header, name)};
  truth = struct ('number', number, 'values', ...
                  cell2struct (num2cell (values(:)), names(:), 1), 'cause', ...
                  of ('cause'), 'y', data.Z(number, :) + given.sd .* noise);
  truth.values.readTime = 0.4;      % of the shear cell, see its loadInput.m
  truth.cells = {of('cause'), phi(phi ~= 0), str2double(of ('d')), ...
                 [of('verdict'), ':', of('effects')]};
end

function makeCase (folder, truth, given, root)
  source = fullfile (root, 'examples', 'hiddenEffect');
  [~, ~] = mkdir (folder);
  copyfile (fullfile (source, 'loadEffects.m'), folder);
  writeValues (folder, fileread (fullfile (source, 'loadInput.m')), truth.y, ...
               given);
end

function writeValues (folder, text, y, given)
  for b = 1:max (given.bench)
    line = sprintf ('optim.targetVal{%d} = %s;', b, ...
                    mat2str (y(given.bench == b), 8));
    text = regexprep (text, sprintf ('optim.targetVal\\{%d\\} = [^;]*;', b), ...
                      line);
  end
  writeAtomic (fullfile (folder, 'loadInput.m'), ...
               strrep (text, '''holdout''', '''calibrate'''));
end

% The neutral plan of another case here.
function takePlan (folder, work, given)
  dem = given.effects(~[given.effects.laboratory]);
  done = glob (fullfile (work, '*', 'gap', 'gap.json'));
  if isempty (done)
    return
  end
  from = fileparts (fileparts (done{1}));
  for file = glob (fullfile (from, 'optim', '*', '*', 'record.json'))'
    record = readRecord (file{1});
    if strcmp (record.stage, 'plan') && ...
       isequal (record.effects(:)', [dem.neutral])
      to = fullfile (folder, 'optim', record.model);
      [~, ~] = mkdir (to);
      copyfile (fileparts (file{1}), to);
    end
  end
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
  text = fileread (fullfile (copy, 'loadInput.m'));
  b = find (strcmp (given.benchNames, test.model));
  own = given.bench == b;
  y = truth.y;
  bench = fullfile (root, 'DEMmodels', test.model);
  z = truthRuns (bench, truth.values, 1, fullfile (copy, 'gap', 'truth'));
  randn ('twister', 9000 + truth.number);
  y(own) = (y(own) + z + given.sd(own) .* randn (1, sum (own))) / 2;
  line = sprintf ('optim.targetStd{%d} = %s;', b, ...
                  mat2str (given.sd(own) / sqrt (2), 6));
  old = sprintf ('optim.targetStd\\{%d\\} = [^;]*;', b);
  text = regexprep (text, old, line);
  trials = sprintf ('\n  optim.trials{%d} = 2 * ones (1, %d);', b, sum (own));
  text = strrep (text, line, [line, trials]);
  writeValues (copy, text, y, given);
  g = diagnosed (copy, root);
end

args = argv ();
runStudy (str2num (['[', args{1}, ']']), make_absolute_filename (args{2}), ...
          make_absolute_filename (args{3}), numel (args) > 3);
