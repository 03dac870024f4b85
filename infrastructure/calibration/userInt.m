% USERINT  Prints the iterations of an optimisation, and stops the DEM stage.
%
% CALL: [STOP, INFO] = userInt (P, VALS, STATE, DEMFLAG)
%       [STOP, INFO] = userInt (P, VALS, STATE, DEMFLAG, OPTIM)
%
%   P        d x 1, the parameter set
%   VALS     struct with iteration and residual, of nonlin_residmin
%   STATE    'init', 'iter' or 'done'
%   DEMFLAG  true: on the DEM models; stop when each target's residual is
%            within optim.tolRes, or after optim.maxIter iterations
%   OPTIM    struct with tolRes, maxIter (default: of loadInput), say (handle
%            that takes the line; default: it is printed)
%   STOP     true: stop;  INFO  why (text, empty: go on)
%
% A residual that is not a number never counts as met.
%
% See also: nonlin_residmin, costFunction

function [stop, info] = userInt (p, vals, state, DEMflag, optim)
  if nargin < 5
    optim = readInput ().optim;
  end
  tol = optim.tolRes;
  if iscell (tol)                       % one model after the other
    tol = cellfun (@(t) t(:), tol(:), 'UniformOutput', false);
    tol = vertcat (tol{:});
  end
  tol = tol(:);
  residual = vals.residual(1:numel (tol));
  shown = sprintf (' %.2f', 100 * residual);
  if numel (residual) > 10
    shown = sprintf (' up to %.2f in %d targets', ...
                     100 * max (abs (residual)), numel (residual));
  end
  if all (isnan (residual))
    shown = ' none, as a run failed or no run was left';
  end
  text = sprintf ('  %s, iteration %d: residuals (%%)%s', ...
                  merge (DEMflag, 'DEM', 'Kriging'), vals.iteration, shown);
  if isfield (optim, 'say')
    optim.say (text);
  else
    printf ('%s\n', text);
  end
  stop = false;
  info = '';
  if DEMflag && ~strcmp (state, 'done')
    if all (abs (residual) <= tol)
      info = 'the residuals of all targets are within their tolerances';
    elseif vals.iteration >= optim.maxIter
      info = 'the number of iterations is reached';
    end
    stop = ~isempty (info);
  end
end

%!shared optim, vals
%! optim = struct ('tolRes', {{[0.01, 0.02]}}, 'maxIter', 3);
%! vals = struct ('iteration', 1, 'residual', [0.005; -0.015; 0.4]);
%!test
%! text = evalc ('[stop, info] = userInt (1, vals, ''iter'', true, optim);');
%! assert (stop && ! isempty (info));
%! assert (! isempty (strfind (text, '0.50 -1.50')));
%!test
%! evalc ('stop = userInt (1, vals, ''iter'', false, optim);');
%! assert (! stop);
%!test
%! % of a set without results
%! lost = struct ('iteration', 1, 'residual', [NaN; NaN; NaN]);
%! text = evalc ('stop = userInt (1, lost, ''iter'', true, optim);');
%! assert (! stop);
%! assert (isempty (strfind (text, 'NaN')));
%! assert (! isempty (strfind (text, 'no run was left')));
%!test
%! % columns of several models, in the order of the models
%! columns = struct ('tolRes', {{[0.006; 0.02], 0.5}}, 'maxIter', 3);
%! evalc ('stop = userInt (1, vals, ''iter'', true, columns);');
%! assert (stop);
%!test
%! vals.residual(1) = NaN;
%! evalc ('stop = userInt (1, vals, ''iter'', true, optim);');
%! assert (! stop);
%! vals.iteration = 3;
%! evalc ('stop = userInt (1, vals, ''iter'', true, optim);');
%! assert (stop);

% SPDX-License-Identifier: GPL-3.0-only
