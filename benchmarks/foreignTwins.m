% FOREIGNTWINS  Twin study on published laws that the diagnosis does not know.
%
% CALL: octave-cli benchmarks/foreignTwins.m [blind|develop] [CASES] [ONLY]
%       octave-cli benchmarks/foreignTwins.m ... pairs SETS [STEP] [MOST]
%
% CASES  per laboratory (105): 4 laboratories of 105 are 420
% ONLY   nulls: cases without a gap, for the level of the test; singles: of one
%        cause; pairs: of two
% SETS   diagnose the pairs both of whose causes have a d of 4 the whole way: so
%        many new parameter sets of the laboratory for each (twinsWhole). Each
%        verdict is kept in results/S-whole: started again it goes on, with
%        another STEP too
% STEP   of these cases every so-manyth (1), MOST  and of those the first (all):
%        one case takes 2 minutes
%
% Draws data sets with a known cause ("twins") from laboratories that the
% diagnosis knows only through noisy runs, writes the truth and its SHA-256,
% diagnoses every twin without it, and scores all of them. The truth follows
% laws of bulk solids with thresholds, kinks and saturation (foreignLab),
% scatter follows the results with heavy tails, and some causes are undeclared
% look-alikes of a listed effect. Writes to results/, with S = foreign-blind,
% foreign-develop, foreign-blind-nulls ...:
%   S-truth.csv, S-truth.sha256   truth, written first
%   S-cases.csv                   what the diagnosis may see
%   S.csv                         every case: truth and verdict
%   S-scores.csv                  figures of merit, 95 % Clopper-Pearson
%
% See also: foreignLab, twinsDraw, twinsDiagnose, twinsScore, foreignLines

1;

function runForeign (kind, perLab, only, whole)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  results = fullfile (root, 'benchmarks', 'results');
  [~, ~] = mkdir (results);
  study = strtrim (sprintf ('%s ', 'foreign', kind, only));
  stem = strrep (study, ' ', '-');
  name = fullfile (results, stem);
  [~, version] = system (sprintf ('git -C "%s" rev-parse HEAD', root));
  mix = twinsMix (study);
  labs = foreignLaboratories (kind);
  twins = twinsDraw (labs, perLab, mix);
  digest = twinsFreeze (name, twins, labs);
  printf ('%s: %d cases, %d laboratories, code %s\n', study, numel (twins), ...
          numel (labs), strtrim (version));
  printf ('truth frozen: SHA-256 %s\n', digest);
  if whole.sets > 0
    numbers = find (cellfun (@min, {twins.dEach}) >= 3.9 & [twins.d] >= 3.9);
    numbers = numbers(1:whole.step:end);
    numbers = numbers(1:min (end, whole.most));
    twins = twins(numbers);
    name = [name, '-whole'];
    verdicts = diagnoseWhole (kind, labs, twins, numbers, whole.sets, ...
                              name);
  else
    verdicts = twinsDiagnose (labs, twins);
  end
  twinsScore (name, twins, verdicts, labs);
end

% Shared out to the cores in turn: a laboratory may be quicker than the others.
function verdicts = diagnoseWhole (kind, labs, twins, numbers, sets, place)
  [~, ~] = mkdir (place);
  n = nproc ();
  share = 1 + mod (0:numel (twins) - 1, n);
  slim = rmfield (labs, {'means', 'measure', 'em'});
  split = @(list) arrayfun (@(i) list(share == i), 1:n, 'UniformOutput', false);
  all_ = @(value) repmat ({value}, 1, n);
  parts = parcellfun (n, @twinsWhole, all_ (kind), all_ (slim), ...
                      split (twins), split (numbers), all_ (sets), ...
                      all_ (place), 'UniformOutput', false, 'VerboseLevel', 0);
  for i = 1:n
    verdicts(share == i) = parts{i};
  end
end

args = argv ();
isOnly = ismember (args, {'nulls', 'singles', 'pairs'});
only = [args{isOnly}];
args = args(~isOnly);
kind = 'blind';
perLab = 105;
if numel (args) > 0
  kind = args{1};
end
if numel (args) > 1
  perLab = str2double (args{2});
end
whole = struct ('sets', 0, 'step', 1, 'most', Inf);
names = fieldnames (whole);
for k = 3:numel (args)
  whole.(names{k - 2}) = str2double (args{k});
end
runForeign (kind, perLab, only, whole);
