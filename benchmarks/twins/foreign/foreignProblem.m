% FOREIGNPROBLEM  Describes a laboratory the way newProblem wants it.
%
% CALL: PROBLEM = foreignProblem (SPEC, SD)
%
%   SPEC        struct of a laboratory, see foreignLab
%   SD          1 x T, standard uncertainty of the measurement
%   PROBLEM     struct, value still NaN
%
% See also: foreignLab, newProblem

function problem = foreignProblem (spec, sd)
  T = numel (spec.bench);
  limits = cell2mat (spec.parameters(:, 2:3))';
  effects = struct ('name', {}, 'variables', {}, 'neutral', {}, 'limits', ...
                    {}, 'siblings', {}, 'laboratory', {}, 'offset', {}, ...
                    'matrix', {});
  for k = 1:rows (spec.effects)
    [name, neutral, range, siblings] = spec.effects{k, :};
    effects(end + 1) = struct ('name', name, 'variables', {{name}}, ...
                               'neutral', neutral, 'limits', range, ...
                               'siblings', {siblings}, 'laboratory', ...
                               false, 'offset', [], 'matrix', []);
  end
  for k = 1:rows (spec.laboratory)
    [name, offset, matrix] = spec.laboratory{k, 1:3};
    effects(end + 1) = struct ('name', name, 'variables', {{}}, ...
                               'neutral', [], 'limits', zeros (2, 0), ...
                               'siblings', {{}}, 'laboratory', true, ...
                               'offset', offset, 'matrix', matrix);
  end
  problem = struct ('value', NaN (1, T), 'sd', sd, 'bench', spec.bench, ...
                    'limits', limits, 'effects', effects);
  problem.benchNames = spec.benchNames;
  problem.names = spec.parameters(:, 1)';
  problem.series = spec.series;
  problem.coordinate = spec.coordinate;
end

%!test % the diagnosis takes every laboratory as it is described
%! kinds = {'blind', 'develop'};
%! for k = 1:2
%!   lab = foreignLab (kinds{k}, 1);
%!   given = lab.problem;
%!   given.value = lab.means (0.5 * ones (1, columns (given.limits)), ...
%!                            zeros (1, numel (given.effects)));
%!   problem = newProblem (given);
%!   assert (numel (problem.effects), numel (given.effects));
%! end
