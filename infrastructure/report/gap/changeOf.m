% CHANGEOF  What gap.json says of a change from a reference.
%
% CALL: S = changeOf (DIAGNOSIS)
%
%   DIAGNOSIS  of diagnoseMatrices, with others (compareConditions)
%   S          struct, see docs/gap.md; [] without a reference

function s = changeOf (diagnosis)
  s = [];
  gapProblem = diagnosis.gapProblem;
  if isempty (gapProblem.reference)
    return
  end
  s = struct ('condition', gapProblem.reference.condition, ...
              'lack', diagnosis.change.size, 'targets', {{}}, ...
              'conditions', {num2cell(diagnosis.others.conditions)}, ...
              'order', {num2cell(diagnosis.others.order)});
  for i = 1:numel (gapProblem.used)
    t = gapProblem.used(i);
    before = gapProblem.reference.value(t);
    own = struct ('model', gapProblem.benchNames{gapProblem.bench(t)}, ...
                  'name', gapProblem.targetNames{t}, 'reference', before, ...
                  'measured', gapProblem.value(t), 'foretold', ...
                  gapProblem.value(t) - diagnosis.where.residual(i), ...
                  'modelled', NaN);
    if ~isempty (diagnosis.howFar)
      at = [diagnosis.howFar.targets.target] == t;
      own.modelled = diagnosis.howFar.targets(at).after;
    end
    s.targets{end + 1} = own;
  end
end

%!assert (changeOf (struct ('gapProblem', struct ('reference', []))), [])
