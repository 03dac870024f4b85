% SEARCHONDEM  One Levenberg-Marquardt search on the DEM, from the found set.
%
% CALL: [P, WHY] = searchOnDEM (WAY, PROBLEM, BOOK)
%
% WAY      struct: respond (handle Z = f (P): n x d sets -> n x T responses;
%          makes runs), slopes (handle J = f (p, residual)), kept (1 x k, rows
%          of costFunction that are fitted), weights (k x 1), maxIter, told
%          (struct for userInt: tolRes, maxIter), say (handle, gets the lines of
%          userInt), isOver (handle, text: why the search should end beside what
%          userInt says; '': it should not)
% PROBLEM  struct of newProblem
% BOOK     containers.Map of calibrateOnDEM: state, iteration (counted on), stop
%          (what userInt said when it stopped)
% P        1 x d, the set that nonlin_residmin hands back
% WHY      text, why it ended
%
% costFunction is called with a handle that gives the responses of the DEM.
%
% See also: calibrateOnDEM, userInt

function [p, why] = searchOnDEM (way, problem, book)
  lo = problem.limits(1, :);
  width = diff (problem.limits);
  d = numel (lo);
  toSet = @(u) lo + u(:)' .* width;
  f = @(u) residualOnDEM (toSet (u), way, problem);
  J = @(u, hook) way.slopes (toSet (u), hook.f(:));
  watch = @(u, vals, phase) watchStage (toSet (u), vals, phase, way, book);
  settings = optimset ('lbound', zeros (d, 1), 'ubound', ones (d, 1), ...
                       'dfdp', J, 'weights', way.weights, ...
                       'MaxIter', way.maxIter, ...
                       'TolFun', problem.options.tolfun, ...
                       'user_interaction', watch);
  state = book('state');
  u = (state.found.params - lo) ./ width;
  u = min (max (u, 0), 1)';
  why = 'the search for active limits of the parameters failed';
  try
    [u, ~, cvg, info] = nonlin_residmin (f, u, settings);
    why = 'the sum of squares no longer decreases';
    if cvg < 0
      why = info.user_interaction.info{1};
    elseif cvg == 0
      why = 'the number of iterations is reached';
    end
  catch err
    % see leastSquaresInBox; the runs are made
    if ~any (strcmp (err.message, {'not successful', 'pivot is zero'}))
      rethrow (err);
    end
  end
  p = toSet (u);
end

function f = residualOnDEM (p, way, problem)
  full = problem.cost (p(:), @(q, varargin) way.respond (q(:)')(:));
  f = full(way.kept)(:);
end

function [stop, info] = watchStage (p, vals, phase, way, book)
  [stop, info] = deal (false, '');
  if strcmp (phase, 'done')
    return
  end
  vals.iteration = book('iteration');
  book('iteration') = vals.iteration + 1;
  runs = sum (isAfterPlan (book('state').data));
  told = way.told;
  told.say = @(text) way.say (sprintf ('%s; %d runs since the plan', ...
                                       text, runs));
  [stop, info] = userInt (p(:), vals, phase, true, told);
  if stop
    book('stop') = info;
  else
    info = way.isOver ();
    stop = ~isempty (info);
  end
end
