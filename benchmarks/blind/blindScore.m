% BLINDSCORE  Lays the answers to a sealed study beside the truth.
%
% CALL: CASES = blindScore (STEM, TRUTH, LAB)
%
%   STEM   path without ending: STEM-answers.csv, STEM-strengths.csv are read
%          (of blindWhere's answers those of the sealed study);
%          STEM-cases-scored.csv and STEM-scores.csv written
%   TRUTH  path of the truth of blindHandOver
%   LAB    struct of blindLab
%   CASES  1 x n struct: truth, answer and what is right, see flagsOf
%
% d of a truth is the norm of what the parameters cannot absorb of the change
% from the model without effects, in units of the whole noise, less what the
% packings of the truth themselves add to it (its expected square).
%
% See also: blind, blindLines

function cases = blindScore (stem, truth, lab)
  truths = tableOf (truth);
  answers = tableOf ([stem, '-answers.csv']);
  strengths = tableOf ([regexprep(stem, '-where$', ''), '-strengths.csv']);
  truths = truths(ismember ({truths.case}, {answers.case}));
  for i = 1:numel (truths)
    at = find (strcmp ({answers.case}, truths(i).case), 1);
    own = strcmp ({strengths.case}, truths(i).case);
    cases(i) = flagsOf (truths(i), answers(at), strengths(own), lab);
  end
  writeCases ([stem, '-cases-scored.csv'], cases);
  blindLines ([stem, '-scores.csv'], cases);
end

% 1 x n struct, all fields text.
function list = tableOf (file)
  [header, cells] = readCsvTable (file);
  list = cell2struct (cells, header, 2)';
end

function c = flagsOf (truth, answer, strengths, lab)
  names = {lab.gapProblem.effects.name};
  cause = strsplit (truth.cause, ' ');
  if strcmp (truth.class, 'unlisted') || strcmp (truth.class, 'null')
    cause = {};
  end
  said = strsplit (answer.effects, ' ');
  said = said(~cellfun (@isempty, said));
  listed = cause(~strcmp (cause, truth.removed));
  c = struct ('number', str2double (truth.case), 'class', truth.class, ...
              'cause', truth.cause, 'forms', truth.forms, 'phi', truth.phi, ...
              'verdict', answer.verdict, 'effects', answer.effects, ...
              'guard', answer.guard);
  [c.d, parts] = detectable (truth, lab);
  c.null = strcmp (truth.class, 'null');
  c.own = strcmp (truth.forms, 'library');
  c.named = strcmp (answer.verdict, 'named');
  c.grouped = strcmp (answer.verdict, 'group');
  c.alarm = ~strcmp (answer.verdict, 'no gap');
  hits = ismember (said, listed);
  c.top = any (strcmp (answer.top, listed));
  c.right = ~isempty (hits) && any (hits) && (c.grouped || all (hits));
  c.clean = c.right && all (hits);
  [c.benchPlaced, c.placed] = isPlaced (parts, answer, lab);
  c.hasStrength = c.own && numel (cause) == 1;
  c.covered = c.hasStrength && holds (strengths, cause, truth.phi);
  c.closure = str2double (answer.closure);
  c.held = str2double (answer.held);
  c.heldHi = str2double (answer.heldHi);
  c.placebo = str2double (answer.placebo);
  c.cureRight = any (ismember (strsplit (answer.cure, '+'), cause));
  c.known = ismember (cause, names);
end

function [d, parts] = detectable (truth, lab)
  gapProblem = lab.gapProblem;
  X = cellfun (@(n) str2double (truth.(n)), gapProblem.names);
  Z = cellfun (@(n) str2double (truth.(n)), gapProblem.targetNames);
  theta = (X - gapProblem.limits(1, :)) ./ diff (gapProblem.limits);
  space = blindSpace (lab, theta);
  shape = Z - space.base;
  shape(~isfinite (shape)) = 0;
  em = lab.em;
  used = gapProblem.used;
  packing = em.noiseVar(used) / lab.trials;
  surrogate = mean (em.surrogateVar(:, used), 1) + em.fitVar(used);
  reading = gapProblem.sd(used).^2;
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
  gapProblem = lab.gapProblem;
  [~, worst] = max (parts);
  score = arrayfun (@(b) norm (parts(gapProblem.bench == b)), ...
                    1:numel (gapProblem.benchNames));
  [~, most] = max (score);
  firstTwo = @(text) strsplit (text, ' ')(1:min (end, 2));
  bench = any (strcmp (gapProblem.benchNames{most}, ...
                       firstTwo (answer.benches)));
  target = any (strcmp (gapProblem.targetNames{worst}, ...
                        firstTwo (regexprep (answer.targets, ...
                                             '\<height\>', 'heapHeight'))));
end

function is = holds (strengths, cause, phi)
  own = strengths(strcmp ({strengths.effect}, cause{1}));
  is = ~isempty (own) && ...
       str2double (own.lo90) <= str2double (phi) + 1e-9 && ...
       str2double (phi) <= str2double (own.hi90) + 1e-9;
end

function writeCases (file, cases)
  lines = {['case,class,cause,forms,phi,d,verdict,effects,guard,top,right,' ...
            'clean,placed,covered,closure,held,placebo']};
  for c = cases
    lines{end + 1} = sprintf ...
      ('%d,%s,%s,%s,%s,%.2f,%s,%s,%s,%d,%d,%d,%d,%d,%.3g,%.3g,%.3g', ...
       c.number, c.class, c.cause, c.forms, c.phi, c.d, c.verdict, ...
       c.effects, c.guard, c.top, c.right, c.clean, c.placed, c.covered, ...
       c.closure, c.held, c.placebo);
    printf ('%s\n', lines{end});
  end
  writeAtomic (file, [strjoin(lines, "\n"), "\n"]);
end
