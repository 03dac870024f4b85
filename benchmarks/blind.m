% BLIND  Sealed cases on LIGGGHTS: the truth is made otherwise, and unread.
%
% CALL: octave-cli benchmarks/blind.m campaign WORK
%       octave-cli benchmarks/blind.m draw NAME SECRET [CASES]
%       octave-cli benchmarks/blind.m answer NAME PLACE [SECRET]
%       octave-cli benchmarks/blind.m whole NAME PLACE SECRET [STEP]
%       octave-cli benchmarks/blind.m score NAME SECRET
%
% campaign  runs what all cases share into benchmarks/blind/storedRuns.csv
%           (WORK keeps the runs)
% draw      draws CASES (60) from random numbers that nobody knows, runs their
%           truth in the folder SECRET and keeps it there; writes
%           NAME-cases.csv and NAME-lists.csv, what a laboratory hands over, and
%           NAME-truth.sha256. Where NAME ends in bins, the laboratory has drum
%           and slot bins (blindLab)
% answer    makes a case folder for each in PLACE, diagnoses it with
%           diagnoseGap.m, without new runs, the folder SECRET hidden; writes
%           NAME-answers.csv and NAME-strengths.csv
% whole     the same for every STEP-th case (7) with 75 new runs of LIGGGHTS, a
%           bench each, cures among them; writes NAME-whole-answers.csv,
%           NAME-whole-strengths.csv
% score     checks the digest, copies the truth, writes NAME-cases-scored.csv;
%           NAME-whole is scored with the truth of NAME
%
% All tables lie in benchmarks/results. Draw, answer and score are committed
% each before the next one begins. What is finished in a folder is used again.
%
% See also: blindDraw, blindForms, blindAnswer, blindScore

1;

function drawCases (root, stem, secret, n)
  [~, ~] = mkdir (secret);
  lab = blindLab (root, stem);
  [truths, isNew] = drawnBefore (secret, lab, n);
  jobs = cell (0, 2);
  for i = 1:n
    for trial = 1:lab.trials
      jobs(end + 1, :) = {truths(i), trial};
    end
  end
  printf ('%d cases, %d trials, drawn %s\n', n, rows (jobs), ...
          {'before', 'now'}{1 + isNew});
  slim = struct ('problem', lab.problem);
  work = fullfile (secret, 'runs');
  parts = parcellfun (nproc (), @blindRun, ...
                      repmat ({slim}, 1, rows (jobs)), jobs(:, 1)', ...
                      jobs(:, 2)', repmat ({work}, 1, rows (jobs)), ...
                      'UniformOutput', false, 'VerboseLevel', 0);
  Z = cell (1, n);
  for i = 1:n
    Z{i} = vertcat (parts{(i - 1) * lab.trials + (1:lab.trials)});
  end
  printf ('%d of %d trials without a result on every bench\n', ...
          sum (cellfun (@(z) any (isnan (z)), parts)), numel (parts));
  blindHandOver (stem, fullfile (secret, 'truth.csv'), lab, truths, Z);
end

% The draw is kept, so that a start that was broken off goes on with it.
function [truths, isNew] = drawnBefore (secret, lab, n)
  file = fullfile (secret, 'draw.mat');
  isNew = exist (file, 'file') ~= 2;
  if isNew
    id = fopen ('/dev/urandom');
    seed = fread (id, 20, 'uint32');
    fclose (id);
    rand ('twister', seed);
    randn ('twister', flipud (seed));
    truths = blindDraw (lab, n);
    save ('-binary', file, 'truths');
  end
  truths = load (file).truths;
end

function answerCases (root, stem, place, secret, step)
  folders = blindCases (stem, blindLab (root, stem), ...
                        make_absolute_filename (place));
  numbers = 1:numel (folders);
  if ~isempty (step)
    numbers = 1:step:numel (folders);
    folders = folders(numbers);
    cellfun (@allowRuns, folders);
    stem = [stem, '-whole'];
  end
  n = nproc ();
  share = 1 + mod (0:numel (folders) - 1, n);
  own = arrayfun (@(i) folders(share == i), 1:n, 'UniformOutput', false);
  parts = parcellfun (n, @blindAnswer, repmat ({root}, 1, n), own, ...
                      repmat ({secret}, 1, n), 'UniformOutput', false, ...
                      'VerboseLevel', 0);
  answers = cell (1, numel (folders));
  for i = 1:n
    answers(share == i) = parts{i};
  end
  [~, code] = system (sprintf ('git -C "%s" rev-parse --short HEAD', root));
  blindTable (stem, numbers, answers, strtrim (code));
  printf ('%d answers of %d\n', sum (~cellfun (@isempty, answers)), ...
          numel (answers));
end

function allowRuns (folder)
  file = fullfile (folder, 'loadInput.m');
  text = strrep (fileread (file), 'maxNewRuns = 0', 'maxNewRuns = 75');
  writeAtomic (file, strrep (text, 'maxCPU = 2', 'maxCPU = 1'));
end

function scoreCases (root, stem, secret)
  truth = fullfile (secret, 'truth.csv');
  [~, digest] = system (sprintf ('sha256sum < "%s"', truth));
  whole = regexprep (stem, '-whole$', '');
  sealed = strtrim (fileread ([whole, '-truth.sha256']));
  if ~strcmp (strtok (digest), sealed)
    error ('DEcalioc:blind:badDigest', ...
           'blind: %s has the digest %s, sealed was %s.', truth, ...
           strtok (digest), sealed);
  end
  copyfile (truth, [whole, '-truth.csv']);
  blindScore (stem, [whole, '-truth.csv'], blindLab (root, stem));
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
args = [argv()', {'', '', '', ''}];
stem = fullfile (root, 'benchmarks', 'results', args{2});
switch args{1}
  case 'campaign'
    blindCampaign (root, make_absolute_filename (args{2}));
  case 'draw'
    n = str2double (args{4});
    if isnan (n)
      n = 60;
    end
    drawCases (root, stem, make_absolute_filename (args{3}), n);
  case 'answer'
    answerCases (root, stem, args{3}, args{4}, []);
  case 'whole'
    step = str2double (args{5});
    if isnan (step)
      step = 7;
    end
    answerCases (root, stem, args{3}, args{4}, step);
  case 'score'
    scoreCases (root, stem, make_absolute_filename (args{3}));
  otherwise
    error ('DEcalioc:blind:unknownName', ...
           ['blind: campaign, draw, answer, whole or score is ' ...
            'wanted, got "%s". See the head of benchmarks/blind.m.'], args{1});
end
