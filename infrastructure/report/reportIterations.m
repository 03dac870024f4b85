% REPORTITERATIONS  Says how the optimisation on the surrogates went.
%
% CALL: reportIterations (FOUND, HISTORY, CASE, SAY)
%
%   FOUND, HISTORY  see calibrateOnKriging
%   CASE            see newCase
%   SAY             function handle that takes one line of text
%
% See also: calibrateOnKriging

function reportIterations (found, history, Case, say)
  T = numel (Case.targets);
  say ('');
  say ('Optimisation on the Kriging models');
  for k = 1:numel (history)
    say (sprintf ('  iteration %d: residuals (%%)%s', ...
                  history(k).iteration, ...
                  residualText (history(k).residual(1:T), ' %.3f')));
  end
  say (sprintf (['  %d starts, the best from: %s; chance that all targets ' ...
                 'are met: %.0f %%'], ...
                numel (found.starts), found.start, 100 * found.probability));
  if ~isempty (found.conflict)
    say (sprintf ('  WARNING: no set of the box meets together: %s', ...
                  strjoin (found.conflict, ', ')));
  end
  say ('');
  say ('Optimisation on the DEM models');
end
