% TWINS  Twin study: how often is the verdict of the diagnosis right?
%
% CALL: octave-cli benchmarks/twins.m [blind|develop] [cases a laboratory]
%
% Draws data sets with a known cause ("twins") from laboratories of formulas
% that the diagnosis knows only through 200 noisy runs each, writes the truth
% and its SHA-256, diagnoses every twin without it, scores all of them:
%   results/twins-truth.csv, twins-truth.sha256   truth, written first
%   results/twins-cases.csv                       what the diagnosis may see
%   results/twins.csv                             every case: truth and verdict
%   results/twins-scores.csv                      figures of merit
%   results/twins-curves.csv, docs/figures/twins.svg  the same over d
% blind (default) and develop use other laboratories, seeds and parameters.
% Formulas of the kind the surrogates are: see foreignTwins and leftOut, too.
%
% See also: twinsDraw, twinsDiagnose, twinsScore, twinsCurves

1;

function runTwins (kind, perLab)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  results = fullfile (root, 'benchmarks', 'results');
  [~, ~] = mkdir (results);
  stem = 'twins';
  if ~strcmp (kind, 'blind')
    stem = [kind, '-twins'];
  end
  name = fullfile (results, stem);
  [~, version] = system (sprintf ('git -C "%s" rev-parse HEAD', root));
  labs = twinsLaboratories (kind);
  twins = twinsDraw (labs, perLab, twinsMix (kind));
  digest = twinsFreeze (name, twins, labs);
  printf ('twins: %d cases, %d laboratories, code %s\n', ...
          numel (twins), numel (labs), strtrim (version));
  printf ('truth frozen: SHA-256 %s\n', digest);
  verdicts = twinsDiagnose (labs, twins);
  twinsScore (name, twins, verdicts, labs);
  twinsCurves (name, fullfile (root, 'docs', 'figures', [stem, '.svg']));
end

args = argv ();
kind = 'blind';
perLab = 105;
if numel (args) > 0
  kind = args{1};
end
if numel (args) > 1
  perLab = str2double (args{2});
end
runTwins (kind, perLab);
