% SWAPSCORE  Lays the answers to lawSwap beside the truth.
%
% CALL: swapScore (ROOT, STEM)
%
%   ROOT  folder of the toolbox
%   STEM  path without ending: STEM-truth.csv, STEM-cases.csv and
%         STEM-answers.csv are read, STEM-scored.csv is written
%
% d is the norm of what the parameters cannot absorb of the measured change, in
% units of the whole noise, less what packings and readings add to it. A case is
% nearer to a rival where the mark of an effect that is not its cause has the
% larger cosine with that. The figures: make figures (gapTables).
%
% See also: lawSwap, gapTables

function swapScore (root, stem)
  truths = tableRows ([stem, '-truth.csv']);
  answers = tableRows ([stem, '-answers.csv']);
  lab = labOf (root);
  lines = {['case,form,cause,strength,d,own,rival,nearest,verdict,effects,' ...
            'class,pSaid,top,p']};
  for i = 1:numel (truths)
    t = truths(i);
    a = answers(strcmp ({answers.case}, t.case));
    s(i) = markOf (lab, t, stem);
    lines{end + 1} = sprintf ('%s,%s,%s,%s,%.2f,%.2f,%.2f,%s,%s,%s,%s,%s,%s,%s', ...
                              t.case, t.form, t.cause, t.strength, s(i).d, ...
                              s(i).own, s(i).rival, s(i).nearest, a.verdict, ...
                              a.effects, a.class90, a.pSaid, a.top, a.p);
  end
  writeTable ([stem, '-scored.csv'], lines);
  printf ('%s\n', lines{:});
end

function lab = labOf (root)
  [given, data] = formChange (root);
  given.sd = given.sd / sqrt (2);
  options = gapOptions ([]);
  lab.given = given;
  lab.problem = newProblem (given);
  lab.emulator = fitEmulator (lab.problem, data, options);
  lab.hypotheses = makeHypotheses (lab.problem, lab.emulator, options);
end

function mark = markOf (lab, t, stem)
  rows_ = tableRows ([stem, '-cases.csv']);
  rows_ = rows_(strcmp ({rows_.case}, t.case));
  change = zeros (1, numel (lab.given.value));
  for k = 1:numel (lab.given.value)
    isIt = strcmp ({rows_.name}, lab.given.targetNames{k}) & ...
           strcmp ({rows_.model}, lab.given.benchNames{lab.given.bench(k)});
    two = str2double ({rows_(isIt).value});
    if numel (two) == 2
      change(k) = diff (two);
    end
  end
  X = cellfun (@(n) str2double (t.(n)), lab.given.names);
  q = 2 * toUnit (X, lab.given.limits) - 1;
  white = lab.hypotheses.white;
  [~, V, ~, J] = predictGap (white, [], q);
  slopes = reshape (vertcat (J{:})', numel (V), white.p) ./ sqrt (V');
  N = parityProjection (slopes, zeros (numel (V), 1)).N;
  used = white.columns;
  seen = N' * (change(used) * white.W' ./ sqrt (V))';
  mark = cosines (lab, t, q, N, V, seen);
  mark.d = sqrt (max (sum (seen.^2) - columns (N), 0));
end

function mark = cosines (lab, t, q, N, V, seen)
  names = {lab.problem.effects.name};
  c = zeros (1, numel (names));
  for k = 1:numel (names)
    [~, ~, S] = predictGap (lab.hypotheses.white, k, ...
                            [q, lab.problem.effects(k).range(2)]);
    m = N' * (S ./ sqrt (V))';
    c(k) = abs (seen' * m) / max (norm (seen) * norm (m), realmin);
  end
  isOwn = ismember (names, strsplit (t.cause, ' '));
  [rival, at] = max (c .* ~isOwn);
  mark = struct ('own', max ([0, c(isOwn)]), 'rival', rival, 'nearest', ...
                 names{at});
end

% SPDX-License-Identifier: GPL-3.0-only
