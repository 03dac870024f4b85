% TWINSOFLAB  Diagnoses the twins of one laboratory (a job of twinsDiagnose).
%
% CALL: VERDICTS = twinsOfLab (LAB, CASES)
%
%   LAB       struct name, problem, em, middle (1 x T, any finite values)
%   CASES     struct Y (n x T), removed (1 x n, effect off the list or 0)
%   VERDICTS  1 x n struct, see twinsDiagnose; temperature, nameAt, expected are
%             those of the laboratory
%
% See also: twinsDiagnose

function verdicts = twinsOfLab (lab, cases)
  options = gapOptions ([]);
  given = lab.problem;
  given.y = lab.middle;
  problem = newGapProblem (given);
  K = numel (lab.em.effect);
  full = makeModels (problem, lab.em, options);
  [full, expected] = calibrateVerdict (problem, lab.em, full, options);
  for removed = unique (cases.removed)
    models = full;
    if removed > 0
      models = makeModels (problem, withoutEffects (lab.em, removed), options);
      models.temperature = full.temperature;
      models.nameAt = full.nameAt;
    end
    for i = find (cases.removed == removed)
      v = oneVerdict (models, cases.Y(i, :), removed, K);
      v.expected = expected.right;
      verdicts(i) = v;
    end
  end
end

function v = oneVerdict (models, y, removed, K)
  start = tic ();
  fits = fitLibrary (models, y);
  w = weighCase (models, fits, 1, true);
  verdict = judgeCase (w, models);
  numbers = setdiff (1:K, removed);
  v = struct ('kind', verdict.kind, 'effects', numbers(verdict.effects), ...
              'top', numbers(verdict.top), 'P', zeros (1, K + 3), ...
              'interval', NaN (K, 3), 'gateP', w.gate.p, ...
              'fitP', max (w.fitP(1:end - 1)), 'seconds', 0, ...
              'temperature', models.temperature, 'nameAt', models.nameAt);
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
  v.seconds = toc (start);
end
