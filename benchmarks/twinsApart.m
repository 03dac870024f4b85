% TWINSAPART  Which strong twins have a listed effect of nearly the same mark.
%
% CALL: octave-cli benchmarks/twinsApart.m [singles CASES]
%
%   CASES  per laboratory, of foreignTwins.m blind CASES singles (default: the
%          cases of foreignTwins.m blind)
%
% Draws the cases again, without a diagnosis, and reads the verdicts of
% results/foreign-blind.csv or foreign-blind-singles.csv. Prints how often
% single causes with d >= 4 are named where another listed effect has a mark of
% cosine 0.9 with the true one, and where none has; and how often each effect
% that is named or grouped has such a mark.
%
% Beside it what somebody could do who knows the laws and weighs the truth
% against its nearest rival alone (testDistance: D standard deviations of
% measurement and packing away, with parameters and strength of its own): the
% log odds are normal with mean D^2 / 2 and deviation D, so the truth is the
% likelier one with probability Phi (D / 2), and reaches 0.9 with
% Phi (D / 2 - log (9) / D). Takes 1 s for each case with d >= 4.
%
% See also: foreignTwins, twinsMark, testDistance

1;

function sayKnown (name, D)
  D = max (D, realmin);
  printf (['laws known, %-30s %3d cases: likeliest %.0f %%, reaches 0.9 in ' ...
           '%.0f %%\n'], [name, ':'], numel (D), ...
          100 * mean (normalTail (-D / 2)), ...
          100 * mean (normalTail (log (9) ./ D - D / 2)));
end

addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
pkg ('load', 'stk');
[study, perLab] = deal ('foreign blind', 105);
if ~isempty (argv ())
  study = ['foreign blind ', argv(){1}];
  perLab = str2double (argv (){2});
end
labs = foreignLaboratories ('blind');
twins = twinsDraw (labs, perLab, twinsMix (study));
[header, cells] = readCsvTable (fullfile (root, 'benchmarks', 'results', ...
                                          [strrep(study, ' ', '-'), '.csv']));
column = @(name) cells(:, strcmp (header, name))';
verdict = column ('verdict');
said = column ('effects');
isRight = strcmp (column ('right'), '1');
n = numel (twins);
[apart, alike, rival] = deal (NaN (1, n));
for i = 1:n
  t = twins(i);
  lab = labs(t.lab);
  names = {lab.gapProblem.effects.name};
  if strcmp (t.class, 'single')
    apart(i) = max (twinsMark (t, setdiff (1:numel (names), t.cause), lab));
    if t.d >= 3.9
      sd = sqrt (lab.noiseSd.^2 + lab.gapProblem.sd.^2);
      rival(i) = testDistance (lab.means, t, sd);
    end
  end
  if ~isempty (said{i}) && t.d > 0
    [~, numbers] = ismember (strsplit (said{i}, ' '), names);
    alike(i) = min (twinsMark (t, numbers, lab));
  end
end
d = [twins.d];
isStrong = strcmp ({twins.class}, 'single') & d >= 3.9;
isNamed = strcmp (verdict, 'named');
isGroup = strcmp (verdict, 'group');
lines = {'single, d >= 4, no other mark of cosine 0.9: named rightly', ...
         isNamed & isRight, isStrong & apart < 0.9; ...
         'single, d >= 4, another mark of cosine 0.9: named rightly', ...
         isNamed & isRight, isStrong & apart >= 0.9; ...
         'the same: named, or a group, all of the true kind', ...
         (isNamed | isGroup) & alike >= 0.9, isStrong & apart >= 0.9; ...
         'single, d >= 4: named, or a group, all of the true kind', ...
         (isNamed | isGroup) & alike >= 0.9, isStrong; ...
         'names of single causes, off the list, look-alikes: true kind', ...
         alike >= 0.9, isNamed & d > 0 & ~strcmp({twins.class}, 'pair')};
for i = 1:rows (lines)
  k = sum (lines{i, 2} & lines{i, 3});
  m = sum (lines{i, 3});
  [lo, hi] = binomialInterval (k, m);
  printf ('%-62s %3d / %3d  [%3.0f, %3.0f]\n', lines{i, 1}, k, m, 100 * lo, ...
          100 * hi);
end
known = rival(isStrong);
isFar = apart(isStrong) < 0.9;
cause = column ('cause')(isStrong);
sayKnown ('all', known);
sayKnown ('no other mark of cosine 0.9', known(isFar));
sayKnown ('another mark of cosine 0.9', known(~isFar));
for name = unique (cause)
  sayKnown (name{1}, known(strcmp (cause, name{1})));
end
