% REPOSESEEDS  Calibrations of a LIGGGHTS model from other seeds: are they true?
%
% CALL: octave-cli benchmarks/reposeSeeds.m SEEDS WORK [PLAN] [CSV] [RIG]
%
%   SEEDS  of plan and packings (Input.seed), e.g. 11:30
%   WORK   folder of the cases (WORK/SEED), kept; a case that lies there goes on
%   PLAN   runs of the first plan (Input.numOfSam), and no form.csv; 0: plan and
%          form.csv of the template
%   CSV    table, to which one row a seed is added, in the columns of
%          peersLiggghts.py (tool says RIG and PLAN); seeds that stand in it are left out
%   RIG    'Large': another rig and other grains than those of form.csv, see storedRepose
%
% Each is the template Repose as decalioc new --model Repose makes it: two
% parameters, angle of repose and mass on the plate to 6 and 4 %, where the set
% that gave the values is known. What a set truly gives, is said by surrogates
% of other runs (storedRepose), whose own uncertainty at the set is printed beside,
% all in tolerances.
%
% See also: peers

1;

function found = oneCase (seed, work, root, plan, store)
  folder = fullfile (work, sprintf ('%d', seed));
  decalioc = fullfile (root, 'bin', 'decalioc');
  if ~isfolder (folder)
    call (sprintf ('cd %s && %s new --model Repose %d', shellQuote (work), ...
                   shellQuote (decalioc), seed));
    file = fullfile (folder, 'loadInput.m');
    text = strrep (fileread (file), 'Input.seed = 1;', ...
                   sprintf ('Input.seed = %d;', seed));
    if plan > 0
      text = regexprep (text, 'numOfSam = \d+', sprintf ('numOfSam = %d', plan));
      unlink (fullfile (folder, 'DEMmodels', 'Repose', 'form.csv'));
    end
    writeAtomic (file, ofRig (text, store));
  end
  call (sprintf ('%s run %s', shellQuote (decalioc), shellQuote (folder)));
  found = jsondecode (fileread (fullfile (folder, 'results', ...
                                          'calibration.json')));
end

function text = ofRig (text, store)
  v = store.variables;
  lines = cellfun (@(name) sprintf ('  modelVars.%s = %g;\n', name, v.(name)), ...
                   fieldnames (v)', 'UniformOutput', false);
  text = regexprep (text, {' *modelVars\.densityP = [^\n]*\n', 'targetVal\{1\} = \[.*?\]'}, ...
                    {[lines{:}], sprintf('targetVal{1} = %s', mat2str (store.problem.value))});
end

% Exit status 2: not all targets are met.
function call (line)
  [status, text] = system ([line, ' 2>&1']);
  if ~any (status == [0, 2])
    error ('DEcalioc:reposeSeeds:runFailed', ...
           'reposeSeeds: %s must end well, got status %d: %s', line, ...
           status, text);
  end
end

args = argv ();
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
pkg ('load', 'stk');
work = make_absolute_filename (args{2});
[~, ~] = mkdir (work);
[args{end + 1:5}] = deal ('');
plan = max ([str2double(args{3}), 0]);
seeds = str2num (args{1});
tool = ['DEcalioc', merge(isempty (args{5}), '', ['; rig ', args{5}]), ...
        merge(plan > 0, sprintf ('; plan of %d; no form.csv', plan), '')];
done = {};
if ~isempty (args{4})
  [done, counted] = startTable (args{4}, 'tool,seed,runs,seconds,worst,wall,error', 2);
end
seeds = seeds(~ismember (arrayfun (@(s) rowText ({tool, s}), seeds, ...
                                   'UniformOutput', false), done));
store = storedRepose (root, args{5});
problem = store.problem;
truth = fitSurrogates (store.data, problem);
use = problem.calibrate;
[isTrue, isMet, stated, runs, seconds] = deal ([]);
for seed = seeds
  started = time ();
  c = oneCase (seed, work, root, plan, store);
  [z, v] = predictSurrogate (truth, cellfun (@(n) c.params.(n), ...
                                             problem.names));
  part = problem.tol(use) .* problem.value(use);
  off = abs (z(use) - problem.value(use)) ./ part;
  isTrue(end + 1) = all (off < 1);
  isMet(end + 1) = c.converged;
  stated(end + 1) = c.probability;
  runs(end + 1) = c.demRuns.plan + c.demRuns.infill + c.demRuns.verify;
  seconds(end + 1) = c.coreSeconds;
  if ~isempty (args{4})
    appendLine (args{4}, rowText ({tool, seed, runs(end), seconds(end), max(off), ...
                                   time() - started, ''}));
  end
  printf (['%4d  %d runs, %.0f core-seconds, calibrated %d, probability ', ...
           '%.3f, truly off by %s (sd %s)\n'], seed, runs(end), ...
          seconds(end), c.converged, c.probability, sprintf ('%.2f ', off), ...
          sprintf ('%.2f ', sqrt (v(use)) ./ part));
end
[lo, hi] = binomialInterval (sum (isTrue & isMet), sum (isMet));
printf (['%d of %d are called calibrated, with a probability of %.2f in ', ...
         'the mean; %d of these truly are (%.0f - %.0f %%)\n'], ...
        sum (isMet), numel (isMet), mean (stated(isMet == 1)), ...
        sum (isTrue & isMet), 100 * lo, 100 * hi);
printf ('runs: %.1f in the mean, %d in the median, %d to %d; core-seconds: %.0f\n', ...
        mean (runs), median (runs), min (runs), max (runs), mean (seconds));

% SPDX-License-Identifier: GPL-3.0-only
