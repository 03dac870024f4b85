% DIAGNOSEDTARGETS  What a diagnosis says of each target, a row a target.
%
% CALL: LIST = diagnosedTargets (DIAGNOSIS)
%
%   DIAGNOSIS  of diagnoseMatrices
%   LIST       1 x n struct array, first the fitted targets, then the held-out
%              ones, then those that the model cannot follow (role 'aside': compared
%              with the reference alone): target (number), model, name, role, measured, predicted,
%              residual, z, p, absorbability (0 of those held out), blind,
%              size, see locateGap

function list = diagnosedTargets (diagnosis)
  where = diagnosis.where;
  problem = diagnosis.problem;
  t = [problem.used(:); problem.heldOut(:)]';
  held = where.held.z(:)';
  isHeld = 1:numel (t) > numel (problem.used);
  roles = {'calibrate', 'holdout'};
  measured = problem.value(t)(:)';
  predicted = [measured(~isHeld) - where.residual(:)', where.held.mean(:)'];
  of = @(fitted, held) num2cell ([fitted(:)', held(:)']);
  list = struct ('target', num2cell (t), ...
                 'model', problem.benchNames(problem.bench(t))(:)', ...
                 'name', problem.targetNames(t)(:)', ...
                 'role', roles(1 + isHeld), 'measured', num2cell (measured), ...
                 'predicted', num2cell (predicted), ...
                 'residual', num2cell (measured - predicted), 'z', of (where.t, held), ...
                 'p', of (where.pTarget, where.held.p), ...
                 'absorbability', of (where.absorbability, 0 * held), ...
                 'blind', of (where.blind, false (size (held))), ...
                 'size', of (where.size, abs (held)));
  list = [list, asideOf(diagnosis, list)];
end

function list = asideOf (diagnosis, list)
  aside = jsonAt (diagnosis, {'change', 'aside'});
  problem = diagnosis.problem;
  list = repmat (list(1), 1, numel (aside));
  for k = 1:numel (aside)
    t = aside(k).target;
    before = problem.reference.value(t);
    list(k) = struct ('target', t, 'model', problem.benchNames{problem.bench(t)}, ...
                      'name', problem.targetNames{t}, 'role', 'aside', ...
                      'measured', problem.value(t), 'predicted', before, ...
                      'residual', problem.value(t) - before, 'z', aside(k).z, ...
                      'p', aside(k).p, 'absorbability', 0, 'blind', false, ...
                      'size', abs (aside(k).z));
  end
end

%!test
%! d.problem = struct ('used', [1, 3], 'heldOut', 2, 'value', [7, 8, 9], ...
%!                        'bench', [1, 1, 2], 'benchNames', {{'A', 'B'}}, ...
%!                        'targetNames', {{'x', 'y', 'z'}});
%! d.where = struct ('residual', [1, 2], 't', [3, 4], 'pTarget', [0.1, 0.2], ...
%!                   'absorbability', [0.5, 0.99], 'blind', [false, true], ...
%!                   'size', [3, 4]);
%! d.where.held = struct ('mean', 8.5, 'z', -2, 'p', 0.04);
%! list = diagnosedTargets (d);
%! assert ({list.name}, {'x', 'z', 'y'});
%! assert ({list.model}, {'A', 'B', 'A'});
%! assert ([list.predicted], [6, 7, 8.5]);
%! assert ([list.residual], [1, 2, -0.5]);
%! assert ({list.role}, {'calibrate', 'calibrate', 'holdout'});
%! assert ([list.size], [3, 4, 2]);
%! % one that the model cannot follow
%! d.problem.used = 1;
%! for name = {'residual', 't', 'pTarget', 'absorbability', 'blind', 'size'}
%!   d.where.(name{1}) = d.where.(name{1})(1);
%! end
%! d.problem.reference = struct ('value', [6, 8, 5]);
%! d.change.aside = struct ('target', 3, 'z', 2, 'p', 0.05);
%! list = diagnosedTargets (d);
%! assert ({list.name}, {'x', 'y', 'z'});
%! assert ({list(3).role, list(3).predicted, list(3).residual, list(3).size}, {'aside', 5, 4, 2});

% SPDX-License-Identifier: GPL-3.0-only
