% BLINDSCORE  Lays the answers to a sealed study beside the truth.
%
% CALL: CASES = blindScore (STEM, TRUTH, LAB)
%
%   STEM   path without ending: STEM-answers.csv, STEM-strengths.csv are read;
%          STEM-cases-scored.csv written
%   TRUTH  path of the truth of blindHandOver
%   LAB    struct of blindLab
%   CASES  1 x n struct for scoreDiagnoses, with truth and answer (rows of the
%          tables), isLibrary (form of the effect), hasStrength, benchPlaced,
%          placed, closure, held, heldHi, placebo
%
% d of a truth is the norm of what the parameters cannot absorb of the change
% from the model without effects, in units of the whole noise, less what the
% packings of the truth themselves add to it (its expected square).
%
% See also: blind, gapTables

function cases = blindScore (stem, truth, lab)
  truths = tableRows (truth);
  answers = tableRows ([stem, '-answers.csv']);
  strengths = tableRows ([stem, '-strengths.csv']);
  truths = truths(ismember ({truths.case}, {answers.case}));
  for i = 1:numel (truths)
    answer = answers(find (strcmp ({answers.case}, truths(i).case), 1));
    mine = strengths(strcmp ({strengths.case}, truths(i).case));
    cases(i) = caseOf (truths(i), answer, mine, lab);
  end
  s = scoreDiagnoses (cases);
  writeCases ([stem, '-cases-scored.csv'], cases, s);
end

function c = caseOf (truth, answer, strengths, lab)
  cause = strsplit (truth.cause, ' ');
  if any (strcmp (truth.class, {'unlisted', 'null'}))
    cause = {};
  end
  said = strsplit (answer.effects, ' ');
  c = struct ('truth', truth, 'answer', answer, 'class', truth.class, ...
              'cause', {cause(~strcmp (cause, truth.removed))}, ...
              'verdict', answer.verdict, 'top', answer.top, 'effects', ...
              {said(~cellfun (@isempty, said))}, ...
              'phi', str2double (truth.phi), 'interval', [], ...
              'isLibrary', strcmp (truth.forms, 'library'));
  c.hasStrength = c.isLibrary && numel (cause) == 1;
  if c.hasStrength
    found = strengths(strcmp ({strengths.effect}, cause{1}));
    c.interval = [str2double({found.lo90}), str2double({found.hi90})];
  end
  [c.d, parts] = detectable (truth, lab);
  [c.benchPlaced, c.placed] = isPlaced (parts, answer, lab);
  for name = {'closure', 'held', 'heldHi', 'placebo'}
    c.(name{1}) = str2double (answer.(name{1}));
  end
end

function [d, parts] = detectable (truth, lab)
  problem = lab.problem;
  X = cellfun (@(n) str2double (truth.(n)), problem.names);
  Z = cellfun (@(n) str2double (truth.(n)), problem.targetNames);
  theta = (X - problem.limits(1, :)) ./ diff (problem.limits);
  space = blindSpace (lab, theta);
  shape = Z - space.base;
  shape(~isfinite (shape)) = 0;
  emulator = lab.emulator;
  used = problem.used;
  packing = emulator.noiseVar(used) / lab.trials;
  surrogate = mean (emulator.surrogateVar(:, used), 1) + emulator.fitVar(used);
  reading = problem.sd(used).^2;
  % the simulated packing is on both sides: of the truth and of the surrogate
  share = mean ((packing + surrogate) ./ (packing + surrogate + reading));
  d2 = space.visible (shape)^2 - share * space.freedom;
  d = sqrt (max (d2, 0));
  parts = abs (space.parts (shape));
  if strcmp (truth.class, 'null')
    d = 0;
  end
end

% The bench and the target with the largest true discrepancy: are they among the
% first two that the answer tells? The laboratory has the height of the heap
% under an old name, see blindCases.
function [bench, target] = isPlaced (parts, answer, lab)
  problem = lab.problem;
  [~, worst] = max (parts);
  score = arrayfun (@(b) norm (parts(problem.bench == b)), ...
                    1:numel (problem.benchNames));
  [~, most] = max (score);
  firstTwo = @(text) strsplit (text, ' ')(1:min (end, 2));
  bench = any (strcmp (problem.benchNames{most}, ...
                       firstTwo (answer.benches)));
  target = any (strcmp (problem.targetNames{worst}, ...
                        firstTwo (regexprep (answer.targets, ...
                                             '\<height\>', 'heapHeight'))));
end

function writeCases (file, cases, s)
  lines = {['case,class,cause,forms,phi,d,verdict,effects,guard,top,right,' ...
            'clean,placed,covered,closure,held,placebo']};
  for i = 1:numel (cases)
    c = cases(i);
    t = c.truth;
    a = c.answer;
    lines{end + 1} = sprintf ...
      ('%s,%s,%s,%s,%s,%.2f,%s,%s,%s,%d,%d,%d,%d,%d,%.3g,%.3g,%.3g', ...
       t.case, t.class, t.cause, t.forms, t.phi, c.d, a.verdict, ...
       a.effects, a.guard, s.top(i), s.right(i), s.clean(i), c.placed, ...
       s.covered(i), c.closure, c.held, c.placebo);
    printf ('%s\n', lines{end});
  end
  writeTable (file, lines);
end
