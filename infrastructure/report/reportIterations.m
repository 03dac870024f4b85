% REPORTITERATIONS  Says how the optimisation on the surrogates went.
%
% CALL: reportIterations (FOUND, HISTORY, CASE, SAY)
%
%   FOUND, HISTORY  see calibrateOnKriging
%   CASE            see newCase
%   SAY             function handle that takes one line of text

function reportIterations (found, history, Case, say)
  T = numel (Case.targets);
  say ('');
  say ('Optimisation on the Kriging models');
  for k = 1:numel (history)
    say (sprintf ('  iteration %d: residuals (%%)%s', ...
                  history(k).iteration, ...
                  residualText (history(k).residual(1:T), ' %.3f')));
  end
  what = 'surest set';
  if strcmp (Case.options.method, 'published')
    what = 'set that was found';
  end
  say (sprintf ('  starts: %d, these iterations from: %s', ...
                numel (found.starts), found.start));
  say (sprintf (['  %s: residuals (%%)%s; chance that all targets ' ...
                 'are met: %.0f %%'], what, ...
                sprintf (' %.3f', 100 * found.residual(1:T)), ...
                100 * found.probability));
  if ~isempty (found.conflict)
    say (sprintf ('  WARNING: no set of the box meets together: %s', ...
                  strjoin (found.conflict, ', ')));
  end
  say ('');
  say ('Optimisation on the DEM models');
end

%!test
%! % the chance belongs to the set it is said of, not to the last iteration
%! folder = tempname ();
%! mkdir (folder);
%! say = @(text) writeAtomic (fullfile (folder, sprintf ('%d', ...
%!                            numel (readdir (folder)))), text);
%! history = struct ('iteration', 3, 'residual', -0.02);
%! found = struct ('residual', 0.001, 'probability', 0.83, 'start', 'here', ...
%!                 'starts', {{1, 2}}, 'conflict', {{}});
%! Case = struct ('targets', 1, 'options', struct ('method', 'robust'));
%! reportIterations (found, history, Case, say);
%! lines = cellfun (@(n) fileread (fullfile (folder, n)), ...
%!                  setdiff (readdir (folder), {'.', '..'}), ...
%!                  'UniformOutput', false);
%! Case.options.method = 'published';
%! one = evalc (['reportIterations (found, history, Case, ', ...
%!               '@(t) printf ("%s\n", t))']);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! chance = lines{find (~cellfun (@isempty, strfind (lines, '83 %')))};
%! assert (! isempty (strfind (chance, 'surest set: residuals (%) 0.100;')));
%! % the published method looks for no surest set
%! assert (isempty (strfind (one, 'surest')));
%! assert (isempty (strfind (chance, '-2.000')));
