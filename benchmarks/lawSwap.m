% LAWSWAP  Sealed changes whose law is not that of the effect that is listed.
%
% CALL: octave-cli benchmarks/lawSwap.m draw SECRET [CASES] [PROCESSES]
%       octave-cli benchmarks/lawSwap.m answer
%       octave-cli benchmarks/lawSwap.m score SECRET
%
% draw    draws CASES (55) from random numbers that nobody knows: a reference on
%         collapse, shear cell and heap, and the same grains with a cause of
%         swapForms; runs two packings of each with LIGGGHTS in the folder
%         SECRET, adds reading errors, and writes lawSwap-cases.csv (what was
%         measured) and lawSwap-truth.sha256
% answer  diagnoses each change from the stored runs of the library's laws;
%         rolling, sliding and wall friction are candidates too (formChange);
%         attraction is listed as SJKR. Writes lawSwap-answers.csv
% score   checks the digest, copies the truth to lawSwap-truth.csv, prints the
%         shares
%
% Tables lie in benchmarks/results. Draw, answer and score are committed each
% before the next one begins. Fewer CASES than were drawn are the first of them.
% Every form is drawn equally often, its strength evenly between a fifth of its
% range and all of it.
%
% See also: swapForms, formChange, formCase

1;

function drawSwaps (root, secret, n, processes)
  [given, ~] = storedCampaign ('hiddenEffect', root);
  [~, ~] = mkdir (secret);
  file = fullfile (secret, 'draw.mat');
  if exist (file, 'file') ~= 2
    truths = drawTruths (given, n);
    save ('-binary', file, 'truths');
  end
  truths = load (file).truths(1:n);
  parts = parcellfun (processes, @swapRun, num2cell (truths), ...
                      repmat ({given}, 1, n), repmat ({secret}, 1, n), ...
                      'UniformOutput', false, 'VerboseLevel', 0);
  lines = {'case,condition,model,name,value'};
  truthLines = {['case,form,cause,strength,', strjoin(given.names, ',')]};
  for i = 1:n
    t = truths(i);
    truthLines{end + 1} = [sprintf('%d,%s,%s,%.4f', i, t.form, ...
                                   strjoin (t.cause, ' '), t.strength), ...
                           sprintf(',%.6g', t.X)];
    lines = [lines, handed(i, parts{i} + t.noise .* given.sd / sqrt (2), given)];
  end
  sealed = fullfile (secret, 'truth.csv');
  writeAtomic (sealed, [strjoin(truthLines, "\n"), "\n"]);
  stem = stemOf (root);
  writeTable ([stem, '-cases.csv'], lines);
  writeAtomic ([stem, '-truth.sha256'], [digestOf(sealed), "\n"]);
  printf ('%d cases, %d values missing\n', n, ...
          sum (cellfun (@(z) sum (isnan (z(:))), parts)));
end

% From numbers that nobody knows; frictions in the lower part of their limits, so
% that there is room above.
function truths = drawTruths (given, n)
  id = fopen ('/dev/urandom');
  seed = fread (id, 20, 'uint32');
  fclose (id);
  rand ('twister', seed);
  randn ('twister', flipud (seed));
  forms = swapForms ();
  order = mod (randperm (n), numel (forms)) + 1;
  seeds = primes (60000);
  seeds = seeds(seeds > 20000);
  for i = 1:n
    theta = rand (1, numel (given.names));
    theta([2, 4]) = 0.6 * theta([2, 4]);
    X = given.limits(1, :) + theta .* diff (given.limits);
    form = forms(order(i));
    truths(i) = struct ('number', i, 'form', form.name, 'cause', ...
                        {form.cause}, 'strength', 0.2 + 0.8 * rand (), ...
                        'X', X, 'seeds', ...
                        reshape (seeds(randperm (numel (seeds), 4)), 2, 2), ...
                        'noise', randn (2, numel (given.value)));
  end
end

function lines = handed (number, Z, given)
  conditions = {'reference', 'changed'};
  lines = {};
  for c = 1:2
    for t = find (isfinite (Z(c, :)))
      lines{end + 1} = sprintf ('%d,%s,%s,%s,%.6g', number, conditions{c}, ...
                                given.benchNames{given.bench(t)}, ...
                                given.targetNames{t}, Z(c, t));
    end
  end
end

function answerSwaps (root)
  how.options = gapOptions (struct ('points', 300, 'effective', 150, 'most', ...
                                    3000, 'leastPoints', 75));
  [given, data] = formChange (root);
  problem = newProblem (given);
  whole = fitEmulator (problem, data, how.options);
  rows_ = tableRows ([stemOf(root), '-cases.csv']);
  numbers = unique (cellfun (@str2double, {rows_.case}));
  lines = {formCase()};
  for i = numbers
    own = measured (given, rows_(strcmp ({rows_.case}, sprintf ('%d', i))), ...
                    problem);
    if i == numbers(1)
      how.reference = referenceOf (own, whole, how);
    end
    truth = struct ('X', mean (given.limits), 'phi', ...
                    zeros (1, numel (given.effects)));
    lines = [lines, formCase('swap', i, own, whole, truth, how)];
    printf ('%s\n', lines{end});
  end
  writeTable ([stemOf(root), '-answers.csv'], lines);
end

function reference = referenceOf (own, emulator, how)
  problem = newProblem (own);
  emulator = emulateChange (emulator, problem);
  hypotheses = makeHypotheses (problem, emulator, how.options, ...
                               find (isfinite (problem.value)));
  reference = gapReference (hypotheses).reference;
end

function given = measured (given, lines, problem)
  values = NaN (2, numel (given.value));
  for one = lines
    bench = find (strcmp (given.benchNames, one.model));
    t = find (strcmp (given.targetNames, one.name) & given.bench == bench);
    values(1 + strcmp (one.condition, 'changed'), t) = str2double (one.value);
  end
  values(:, any (isnan (values), 1)) = NaN;
  sd = given.sd / sqrt (2);
  given.value = values(2, :);
  given.sd = sd;
  given.trials = 2 * ones (size (problem.trials));
  given.reference = struct ('value', values(1, :), 'sd', sd, 'trials', ...
                            given.trials, 'scatter', problem.scatter, ...
                            'perCondition', false (1, columns (given.limits)));
end

function scoreSwaps (root, secret)
  stem = stemOf (root);
  sealed = fullfile (secret, 'truth.csv');
  if ~strcmp (digestOf (sealed), strtrim (fileread ([stem, '-truth.sha256'])))
    error ('DEcalioc:lawSwap:badDigest', ...
           'lawSwap: %s is not the truth that was sealed.', sealed);
  end
  copyfile (sealed, [stem, '-truth.csv']);
  swapScore (root, stem);
end

function text = digestOf (file)
  [~, text] = system (sprintf ('sha256sum < "%s"', file));
  text = strtok (text);
end

function stem = stemOf (root)
  stem = fullfile (root, 'benchmarks', 'results', 'lawSwap');
end

addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
words = argv ();
[words{end + 1:4}] = deal ('');
switch words{1}
  case 'draw'
    n = 55;
    if ~isempty (words{3})
      n = str2double (words{3});
    end
    processes = nproc ();
    if ~isempty (words{4})
      processes = str2double (words{4});
    end
    drawSwaps (root, make_absolute_filename (words{2}), n, processes);
  case 'answer'
    answerSwaps (root);
  case 'score'
    scoreSwaps (root, make_absolute_filename (words{2}));
end

% SPDX-License-Identifier: GPL-3.0-only
