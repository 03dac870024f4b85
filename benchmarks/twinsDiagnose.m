% TWINSDIAGNOSE  Diagnoses every twin from its observables alone.
%
% CALL: VERDICTS = twinsDiagnose (LABS, TWINS)
%
%   LABS, TWINS  of twinsLaboratories, twinsDraw; of TWINS only lab, removed
%                (the list is shorter then) and y are looked at
%   VERDICTS     1 x n struct: kind, effects, top, named (cellstr), P (1 x (K +
%                3): null, each effect, pairs, unlisted), interval (K x 3:
%                strength of each effect, median and 90 %), gateP, fitP, seconds
%
% One emulator and one calibration of the verdict a laboratory and list.
%
% See also: weighCase, judgeCase, twins

function verdicts = twinsDiagnose (labs, twins)
  blank = struct ('kind', '', 'effects', [], 'top', 0, 'P', [], ...
                  'interval', [], 'gateP', 1, 'fitP', 1, 'seconds', 0);
  verdicts = repmat (blank, 1, numel (twins));
  options = gapOptions ([]);
  for l = 1:numel (labs)
    given = labs(l).problem;
    given.y = labs(l).means (0.5 * ones (1, columns (given.limits)), ...
                             zeros (1, numel (given.effects)));
    problem = newGapProblem (given);
    em = labs(l).em;
    here = find ([twins.lab] == l);
    lists = unique ([twins(here).removed]);
    full = makeModels (problem, em, options);
    [full, expected] = calibrateVerdict (problem, em, full, options);
    printf ('%s: temperature %.1f, names at %.2f, expected right %.2f\n', ...
            labs(l).name, full.temperature, full.nameAt, expected.right);
    for removed = lists
      models = full;
      if removed > 0
        shorter = withoutEffects (em, removed);
        models = makeModels (problem, shorter, options);
        models.temperature = full.temperature;
        models.nameAt = full.nameAt;
      end
      for i = here([twins(here).removed] == removed)
        verdicts(i) = oneVerdict (models, twins(i).y, removed, ...
                                  numel (em.effect), blank);
      end
    end
  end
end

function v = oneVerdict (models, y, removed, K, v)
  start = tic ();
  fits = fitLibrary (models, y);
  w = weighCase (models, fits, 1, true);
  verdict = judgeCase (w, models);
  numbers = setdiff (1:K, removed);
  v.kind = verdict.kind;
  v.effects = numbers(verdict.effects);
  v.top = numbers(verdict.top);
  v.P = zeros (1, K + 3);
  v.interval = NaN (K, 3);
  for h = 1:numel (verdict.P)
    switch w.kind{h}
      case 'null'
        at = 1;
      case 'single'
        at = 1 + numbers(w.members{h});
        v.interval(numbers(w.members{h}), :) = w.phi(h, :);
      case 'pair'
        at = K + 2;
      otherwise
        at = K + 3;
    end
    v.P(at) = v.P(at) + verdict.P(h);
  end
  v.gateP = w.gate.p;
  v.fitP = max (w.fitP(1:end - 1));
  v.seconds = toc (start);
end
