% FINERSTEP  What one level finer than the last would do to the responses.
%
% CALL: STEP = finerStep (SURROGATES, PROBLEM, SET)
%
%   SURROGATES  1 x T struct of fitSurrogates, of plain runs at all levels
%   PROBLEM     see newProblem, with levels
%   SET         1 x d, parameters
%   STEP        struct variables (1 x v cell), value and finer (1 x v: the last
%               level, and one that is finer by as much as the last is finer
%               than the one before), shift and shiftSd (1 x T: what going there
%               is expected to do at SET; NaN where the levels tell nothing)

function step = finerStep (surrogates, problem, set)
  values = problem.coarse.levels;
  step = struct ('variables', {problem.coarse.variables}, ...
                 'value', values(end, :), 'finer', nextFiner (values));
  for t = numel (surrogates):-1:1
    level = unitLevel (problem.coarse, step.finer, t);
    [step.shift(t), step.shiftSd(t)] = levelShift (surrogates(t), set, level);
  end
end

% By the same ratio, of sizes; by the same step where a level is not above 0.
function finer = nextFiner (values)
  finer = 2 * values(end, :) - values(end - 1, :);
  isSize = all (values > 0, 1);
  ratio = values(end, isSize) ./ values(end - 1, isSize);
  finer(isSize) = values(end, isSize) .* ratio;
end

%!test
%! % sizes go on by their ratio; a level that tells nothing says so
%! problem.coarse = struct ('variables', {{'size'}}, 'levels', [4; 2], ...
%!                          'column', 1);
%! s = struct ('level', []);
%! step = finerStep (s, problem, 0.5);
%! assert ({step.value, step.finer, step.shift}, {2, 1, NaN});
%! problem.coarse.levels = [1; 0];
%! assert (finerStep (s, problem, 0.5).finer, -1);
