% LEVELCANDIDATE  Adds how coarse the model is to the candidates.
%
% CALL: GIVEN = levelCandidate (GIVEN, SURROGATES, DATA, PROBLEM)
%
%   GIVEN       of gapProblemOf
%   SURROGATES  see finerStep
%   DATA        plain runs at all levels, E n x v
%   PROBLEM     see newProblem
%   GIVEN       with one more effect, named after the first variable of the
%               levels: full strength is the next finer level (finerStep), at
%               the run of the last level that is nearest to the measurement.
%               The same where the levels tell nothing of it, or where the user
%               has a candidate of that name
%
% It acts on the results as an effect of the laboratory does, known as well as
% the surrogates know what the levels change: no run is made for it.

function given = levelCandidate (given, surrogates, data, problem)
  name = problem.coarse.variables{1};
  isNamed = ~isempty (given.effects) && ...
            any (strcmp ({given.effects.name}, name));
  last = keepRows (data, all (data.E == problem.coarse.levels(end, :), 2));
  miss = (last.Z - given.value) ./ given.sd;
  [~, nearest] = min (mean (miss(:, problem.calibrate).^2, 2));
  if isNamed || isempty (nearest) || isempty (given.effects)
    return
  end
  step = finerStep (surrogates, problem, last.X(nearest, :));
  if any (isnan (step.shift))
    return
  end
  own = given.effects(end);
  own.name = name;
  own.label = sprintf ('%s = %.4g instead of %.4g, share of the way', ...
                       name, step.finer(1), step.value(1));
  [own.unit, own.group, own.siblings] = deal ('', '', {});
  [own.variables, own.neutral, own.limits] = deal ({}, [], zeros (2, 0));
  [own.laboratory, own.strongest, own.scale] = deal (true, 1, 2);
  own.range = [0, 1];
  own.offset = step.shift;
  own.offsetSd = step.shiftSd;
  own.matrix = zeros (numel (step.shift));
  given.effects(end + 1) = own;
end

%!test
%! % the shift of the next finer level at the nearest run, once
%! pkg load stk
%! rand ('twister', 5);
%! X = rand (24, 1);
%! level = [2 * ones(12, 1); ones(12, 1)];
%! data = addRows (newData (1, 1), X, X + 0.2 * level, ones (24, 1), 'plan', ...
%!                 level);
%! C = struct ('names', {{'a'}}, 'limits', [0; 1], ...
%!             'targets', struct ('value', 0.5, 'tol', 0.01));
%! problem = newProblem (C, []);
%! problem.coarse = struct ('variables', {{'size'}}, 'levels', [2; 1], ...
%!                          'column', 1);
%! surrogates = fitSurrogates (data, problem);
%! given = problem;
%! given.sd = 0.1;
%! given.effects = newEffect (struct ('name', 'gain', 'laboratory', true), 1);
%! given = levelCandidate (given, surrogates, data, problem);
%! assert (given.effects(2).name, 'size');
%! assert (given.effects(2).offset, -0.1, 0.05);
%! again = levelCandidate (given, surrogates, data, problem);
%! assert (numel (again.effects), 2);
