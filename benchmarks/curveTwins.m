% CURVETWINS  Twin study on a curve whose errors are correlated.
%
% CALL: octave-cli benchmarks/curveTwins.m [CASES]
%
% CASES  a correlation (60): half of them without a gap, half with one effect
%
% Three benches, one of which gives a curve of 60 points (the mass that has left
% a bin over time). Errors of neighbours are correlated by 0, 0.5 and 0.9: one
% laboratory each, of the same laws; the covariance is declared as it is. Writes
% the files of twins.m to results/curves-*.csv and curves.csv.
%
% See also: foreignLab, labCurve, foreignTwins, curveLines

1;

function runCurves (perLab)
  addpath (fileparts (mfilename ('fullpath')));
  root = startBenchmarks ();
  results = fullfile (root, 'benchmarks', 'results');
  [~, ~] = mkdir (results);
  name = fullfile (results, 'curves');
  [~, version] = system (sprintf ('git -C "%s" rev-parse HEAD', root));
  labs = foreignLaboratories ('curve');
  twins = twinsDraw (labs, perLab, twinsMix ('curve'));
  digest = twinsFreeze (name, twins, labs);
  printf ('curves: %d cases, code %s\n', numel (twins), strtrim (version));
  printf ('truth frozen: SHA-256 %s\n', digest);
  verdicts = twinsDiagnose (labs, twins);
  twinsScore (name, twins, verdicts, labs, @curveLines);
end

args = argv ();
perLab = 60;
if numel (args) > 0
  perLab = str2double (args{1});
end
runCurves (perLab);
