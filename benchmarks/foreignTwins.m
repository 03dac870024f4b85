% FOREIGNTWINS  Twin study on published laws that the diagnosis does not know.
%
% CALL: octave-cli benchmarks/foreignTwins.m [blind|develop] [CASES] [nulls]
%
% CASES  a laboratory (105);  nulls  only cases without a gap, for the level of
%        the test: 4 laboratories of 105 are 420
%
% As twins.m, but the truth follows laws of bulk solids with thresholds, kinks
% and saturation (foreignLab), scatter follows the results with heavy tails, and
% some causes are undeclared look-alikes of a listed effect. Writes to results/,
% with S = foreign-blind, foreign-develop, foreign-blind-nulls ...:
%   S-truth.csv, S-truth.sha256   truth, written first
%   S-cases.csv                   what the diagnosis may see
%   S.csv                         every case: truth and verdict
%   S-scores.csv                  figures of merit, 95 % Clopper-Pearson
%   S-curves.csv, docs/figures/S.svg   the same over d (not of nulls)
%
% See also: foreignLab, twinsDraw, twinsDiagnose, twinsScore, foreignLines

1;

function runForeign (kind, perLab, isNulls)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  results = fullfile (root, 'benchmarks', 'results');
  [~, ~] = mkdir (results);
  study = ['foreign ', kind, repmat(' nulls', 1, isNulls)];
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
  twinsScore (name, twins, verdicts, labs, @foreignLines);
  if ~isNulls
    twinsCurves (name, fullfile (root, 'docs', 'figures', [stem, '.svg']), ...
                 [1:4, 6, 8, 10, 12]);
  end
end

args = argv ();
isNulls = any (strcmp (args, 'nulls'));
args = args(~strcmp (args, 'nulls'));
kind = 'blind';
perLab = 105;
if numel (args) > 0
  kind = args{1};
end
if numel (args) > 1
  perLab = str2double (args{2});
end
runForeign (kind, perLab, isNulls);
