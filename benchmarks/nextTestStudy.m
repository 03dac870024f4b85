% NEXTTESTSTUDY  Does the advised test name the cause that was left open?
%
% CALL: octave-cli benchmarks/nextTestStudy.m KIND NUMBERS CSV
%
%   KIND     blind or develop, of foreignLab
%   NUMBERS  laboratories, e.g. 201:260: one case each (their laws in turn,
%            other constants than in other studies)
%   CSV      table, to which one row a case is added; cases that stand in it are
%            not made again
%
% Laboratories of foreign laws with benches to choose from (twins/testsOfLab):
% benches held back, and other settings of those of the case, are what it could
% measure next. A case is drawn from its number (twins/testCase): one cause with
% a signal to noise of 4, 5, 6 or 8. It is diagnosed from an empty store, as
% planStudy does it. Withheld are cases whose verdict is a group or undecided,
% unless only a look-alike that nobody listed keeps the name back: then the kind
% of cause is known. There the advised test is measured with the truth, three
% trials, and the diagnosis goes on with it: all runs so far, those that were
% made to seek the test, the neutral runs and half of those of each effect on
% the new bench (completePlan), and what the plan then asks for. Beside it,
% in the same cases, the bench that tells most of those measured already, once
% more, with as many further runs as the plan asks for.
%
% Right is a name of the true cause, or a verdict that it is this one or
% something that looks like it. The table also holds d, the verdict before, what
% was expected of the test, and log2 of how much likelier the truth is after it.
%
% See also: adviseTests, testCase, planStudy

1;

function runStudy (kind, numbers, file)
  addpath (fileparts (mfilename ('fullpath')));
  startBenchmarks ();
  pkg ('load', 'stk');
  if ~isfile (file)
    appendLine (file, ['kind,number,laboratory,truth,d,before,sets,test,', ...
                       'gain,between,after,setsAfter,right,wrong,bits,', ...
                       'onceBench,onceGain,once,onceRight,onceWrong']);
  end
  done = regexp (fileread (file), '^\w+,\w+', 'match', 'lineanchors');
  for number = numbers
    if ~any (strcmp (done, sprintf ('%s,%d', kind, number)))
      appendLine (file, oneCase (kind, number));
    end
  end
  sayShares (file);
end

function line = oneCase (kind, number)
  [lab, twin] = testCase (kind, number);
  names = {lab.problem.effects.name};
  given = setfield (lab.problem, 'value', twin.y);
  if twin.d < 4                  % nothing there can reach what was drawn
    line = sprintf ('%s,%d,%s,%s,%.4g,,,too weak%s', kind, number, lab.name, ...
                    names{twin.cause}, twin.d, repmat (',', 1, 12));
    return
  end
  first = diagnoseLab (setfield (given, 'tests', @() lab.tests), ...
                       neutralRuns (lab), runsOfLab (lab.run, lab.problem));
  cells = {kind, number, lab.name, names{twin.cause}, twin.d, ...
           said(first), rows(first.data.X)};
  [~, isOpen] = testOutcome (first.which, names{twin.cause});
  if ~isOpen
    cells(8:20) = {'not withheld', '', '', '', '', '', '', '', '', '', '', ...
                   '', ''};
  else
    cells = [cells, withheld(lab, twin, given, first, names{twin.cause})];
  end
  line = rowText (cells);
end

function data = neutralRuns (lab)
  n = neutralSets (columns (lab.problem.limits));
  data = foreignPlan (lab, n, 0);
end

function text = said (d)
  text = [d.which.verdict, ':', strjoin(d.which.effects, '+')];
end

% What the advised test makes of a case, and the same bench once more.
function cells = withheld (lab, twin, given, first, truth)
  tests = first.next;
  best = tests(1);
  once = tests(find ([tests.runs] == 0, 1));
  again = onceMore (lab, twin, given, first, once);
  after = first;
  if best.gain >= gapOptions ([]).adviseAt
    after = again;
    if best.runs > 0
      at = find (strcmp ({lab.tests.model}, best.model), 1);
      after = withTest (lab.tests(at), twin, first);
    elseif ~strcmp (best.test, once.test)
      after = onceMore (lab, twin, given, first, best);
    end
  end
  p = @(d) max (d.which.posterior.(truth), 1e-3);
  cells = [{best.test, best.gain, strjoin(best.between, ' or '), ...
            said(after), rows(after.data.X)}, ...
           testOutcome(after.which, truth), ...
           {log2(p (after) / p (first)), once.model, once.gain, ...
            said(again)}, testOutcome(again.which, truth)];
end

% Three trials of the truth; the sets of the case on the new bench, and the runs
% that were made to seek it.
function d = withTest (test, twin, first)
  y = mean (test.run (repmat (twin.theta, 3, 1), ...
                      repmat (twin.phi, 3, 1)), 1);
  y = y + test.sd .* randn (size (y));
  given = setfield (test.joined, 'value', [twin.y, y]);
  runs = runsOfLab (test.run, given);
  data = first.data;
  T = columns (data.Z);
  some = someSets (data, given.effects);
  Z = NA (rows (data.X), numel (y));
  Z(some, :) = runs (data.X(some, :), data.E(some, :));
  data.Z = [data.Z, Z];
  seen = test.seen ();
  n = rows (seen.X);
  data.X = [data.X; seen.X];
  data.E = [data.E; seen.E];
  data.Z = [data.Z; NA(n, T), seen.Z];
  data.replicate = [data.replicate; ones(n, 1)];
  d = diagnoseLab (given, data, runsOfLab (test.both, given));
end

% All neutral sets, half of those of each effect, eight at least.
function some = someSets (data, effects)
  dem = ~[effects.laboratory];
  isOff = data.E == [effects(dem).neutral];
  some = all (isOff, 2);
  for k = 1:columns (isOff)
    own = find (~isOff(:, k));
    n = min (numel (own), max (8, ceil (numel (own) / 2)));
    some(own(round (linspace (1, numel (own), n)))) = true;
  end
end

% The same bench again: the mean of both, of twice the trials.
function d = onceMore (lab, twin, given, first, test)
  own = given.bench == find (strcmp (given.benchNames, test.model));
  again = lab.measure (twin.theta, twin.phi);
  given.value(own) = (twin.y(own) + again(own)) / 2;
  given.sd(own) = given.sd(own) / sqrt (2);
  given.trials = 1 + own;
  d = diagnoseLab (given, first.data, runsOfLab (lab.run, lab.problem));
end

function sayShares (file)
  [header, cells] = readCsvTable (file);
  isOut = ismember (cells(:, strcmp (header, 'test')), ...
                    {'not withheld', 'too weak'});
  printf ('%d cases of d >= 4\n', ...
          sum (~strcmp (cells(:, strcmp (header, 'test')), 'too weak')));
  cells = cells(~isOut, :);
  of = @(name) str2double (cells(:, strcmp (header, name)));
  isAdvised = of ('gain') >= 0.2;
  printf ('%d withheld cases, advice in %d\n', rows (cells), sum (isAdvised));
  sayShare ('advised test: named rightly, of all', of ('right'));
  sayShare ('  where there is advice', of ('right')(isAdvised));
  sayShare ('  wrongly, of all', of ('wrong'));
  sayShare ('once more: named rightly', of ('onceRight'));
  sayShare ('  wrongly', of ('onceWrong'));
  printf (['expected %.2f bit in the mean; log2 of how much likelier the ', ...
           'true cause is then: %.2f\n'], mean (of ('gain')(isAdvised)), ...
          mean (of ('bits')(isAdvised)));
end

function sayShare (text, is)
  [lo, hi] = binomialInterval (sum (is), numel (is));
  printf ('%-40s %d / %d = %.0f %% (%.0f - %.0f)\n', text, sum (is), ...
          numel (is), 100 * mean (is), 100 * lo, 100 * hi);
end

args = argv ();
runStudy (args{1}, str2num (args{2}), args{3});
