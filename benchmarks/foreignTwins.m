% FOREIGNTWINS  Twin study on published laws that the diagnosis does not know.
%
% CALL: octave-cli benchmarks/foreignTwins.m [blind|develop] [CASES] [ONLY]
%
% CASES  per laboratory (105): 4 laboratories of 105 are 420
% ONLY   nulls: cases without a gap, for the level of the test; singles: of one
%        cause; pairs: of two
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
%
% See also: foreignLab, twinsDraw, twinsDiagnose, twinsScore, gapTables

1;

function runForeign (kind, perLab, only)
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
  verdicts = twinsDiagnose (labs, twins);
  twinsScore (name, twins, verdicts, labs);
  printf ('Figures: octave-cli benchmarks/figures.m show foreign %s.csv\n', name);
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
runForeign (kind, perLab, only);
