% REPORTITERATIONS  Says how the optimisation on the surrogates went.
%
% CALL: reportIterations (FOUND, HISTORY, CASE, SAY)
%
%   FOUND, HISTORY  see calibrateOnKriging;  CASE  see newCase
%   SAY             function handle that takes one line of text

function reportIterations (found, history, Case, say)
  T = numel (Case.targets);
  tell = @(varargin) say (sprintf (varargin{:}));
  say ('');
  say ('Optimisation on the Kriging models');
  for k = 1:numel (history)
    tell ('  iteration %d: residuals (%%)%s', history(k).iteration, ...
          residualText (history(k).residual(1:T), ' %.3f'));
  end
  what = {'surest set', 'set that was found'};
  tell ('  starts: %d, these iterations from: %s', numel (found.starts), ...
        found.start);
  tell (['  %s: residuals (%%)%s; chance that all targets are met: ' ...
         '%.0f %%'], what{1 + strcmp(Case.options.method, 'published')}, ...
        sprintf (' %.3f', 100 * found.residual(1:T)), ...
        100 * found.probability);
  if ~isempty (found.conflict)
    tell ('  WARNING: no set of the box meets together: %s', ...
          strjoin (found.conflict, ', '));
  end
  say ('');
  say ('Optimisation on the DEM models');
end

%!test
%! % the chance belongs to the set it is said of, not to the last iteration
%! history = struct ('iteration', 3, 'residual', -0.02);
%! found = struct ('residual', 0.001, 'probability', 0.83, 'start', 'here', ...
%!                 'starts', {{1, 2}}, 'conflict', {{}});
%! Case = struct ('targets', 1, 'options', struct ('method', 'robust'));
%! text = evalc ('reportIterations (found, history, Case, @disp)');
%! assert (! isempty (strfind (text, ['surest set: residuals (%) 0.100; ', ...
%!                            'chance that all targets are met: 83 %'])));
%! % the published method looks for no surest set
%! Case.options.method = 'published';
%! text = evalc ('reportIterations (found, history, Case, @disp)');
%! assert (isempty (strfind (text, 'surest')));
