% USERINT  Prints the iterations of an optimisation, and stops the DEM stage.
%
% CALL: [STOP, INFO] = userInt (P, VALS, STATE, DEMFLAG)
%       [STOP, INFO] = userInt (P, VALS, STATE, DEMFLAG, OPTIM, SAY)
%
%   P        d x 1, the parameter set
%   VALS     struct with iteration and residual, of nonlin_residmin
%   STATE    'init', 'iter' or 'done'
%   DEMFLAG  true: on the DEM models; stop when each target's residual is
%            within optim.tolRes, or after optim.maxIter iterations
%   OPTIM    struct with targetVal, tolRes, maxIter (default: of loadInput)
%   SAY      function handle that takes one line of text (default: disp)
%   STOP     true: stop;  INFO  why (text, empty: go on)
%
% A residual that is not a number never counts as met.
%
% See also: nonlin_residmin, costFunction

function [stop, info] = userInt (p, vals, state, DEMflag, optim, say)
  if nargin < 5
    [~, optim] = loadInput ();
  end
  if nargin < 6
    say = @disp;
  end
  tol = asColumn (optim.tolRes);
  residual = vals.residual(1:numel (tol));
  models = {'Kriging', 'DEM'};
  say (sprintf ('  %s, iteration %d: residuals (%%)%s', models{1 + DEMflag}, ...
                vals.iteration, sprintf (' %.2f', 100 * residual)));
  stop = false;
  info = '';
  if DEMflag && ~ strcmp (state, 'done')
    if all (abs (residual) <= tol)
      info = 'the residuals of all targets are within their tolerances';
    elseif vals.iteration >= optim.maxIter
      info = 'the number of iterations is reached';
    end
    stop = ~ isempty (info);
  end
end

function c = asColumn (values)
  if iscell (values)
    values = horzcat (values{:});
  end
  c = values(:);
end

%!shared optim, vals, quiet
%! optim = struct ('tolRes', {{[0.01, 0.02]}}, 'maxIter', 3);
%! vals = struct ('iteration', 1, 'residual', [0.005; -0.015; 0.4]);
%! quiet = @(text) [];
%!test
%! [stop, info] = userInt (1, vals, 'iter', true, optim, quiet);
%! assert (stop && ! isempty (info));
%!assert (! userInt (1, vals, 'iter', false, optim, quiet))
%!test
%! vals.residual(1) = NaN;
%! assert (! userInt (1, vals, 'iter', true, optim, quiet));
%! vals.iteration = 3;
%! assert (userInt (1, vals, 'iter', true, optim, quiet));
