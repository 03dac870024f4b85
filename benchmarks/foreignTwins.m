% FOREIGNTWINS  Twin study on published laws that the diagnosis does not know.
%
% CALL: octave-cli benchmarks/foreignTwins.m blind [CASES] [singles]
%
% CASES    per laboratory (105): 4 laboratories of 105 are 420
% singles  cases of one cause alone
%
% Draws data sets with a known cause ("twins") from laboratories that the
% diagnosis knows only through noisy runs, diagnoses every twin, and scores all of
% them. The truth follows laws of bulk solids with thresholds, kinks and saturation
% (foreignLab), scatter follows the results with heavy tails, and some causes are
% undeclared look-alikes of a listed effect. Writes results/foreign-blind.csv or
% foreign-blind-singles.csv: every case, truth and verdict.
%
% See also: foreignLab, twinsDraw, twinsDiagnose, twinsScore, gapTables

1;

% Of each: name, problem (value still NaN), data (40 neutral runs, 20 for each effect of
% DEM), means, measure, noiseSd, isSigned, emulator (of fitEmulator), noise (1 x T:
% measurement, packing and surrogate).
function labs = foreignLaboratories (numbers)
  runs = 40;
  for i = 1:numel (numbers)
    lab = foreignLab (numbers(i));
    rand ('twister', 520 + numbers(i));
    randn ('twister', 520 + numbers(i));
    one = struct ('name', lab.name, 'problem', lab.problem, ...
                  'data', lab.plan (runs, 20), 'means', lab.means, ...
                  'measure', lab.measure, 'noiseSd', lab.noiseSd, ...
                  'isSigned', lab.isSigned);
    given = lab.problem;
    given.value = mean (one.data.Z);
    one.emulator = fitEmulator (newProblem (given), one.data, gapOptions ([]));
    surrogate = mean (one.emulator.surrogateVar, 1);
    one.noise = sqrt (lab.problem.sd.^2 + lab.noiseSd.^2 + surrogate);
    labs(i) = one;
  end
end

addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
args = argv ();
[kind, perLab] = deal ('all', 105);
if any (strcmp (args, 'singles'))
  kind = 'singles';
end
given = str2double (args);
if any (isfinite (given))
  perLab = given(isfinite (given))(1);
end
name = fullfile (root, 'benchmarks', 'results', ...
                 ['foreign-blind', merge(strcmp (kind, 'singles'), '-singles', '')]);
labs = foreignLaboratories (1:4);
twins = twinsDraw (labs, perLab, twinsMix (kind));
printf ('%d cases, %d laboratories\n', numel (twins), numel (labs));
twinsScore (name, twins, twinsDiagnose (labs, twins), labs);
printf ('Figures: octave-cli benchmarks/figures.m show foreign %s.csv\n', name);

% SPDX-License-Identifier: GPL-3.0-only
