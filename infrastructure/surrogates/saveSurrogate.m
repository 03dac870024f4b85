% SAVESURROGATE  Keeps a surrogate as a text file of plain numbers.
%
% CALL: saveSurrogate (FILE, SURROGATE)
%
% FILE       char, path; SURROGATE  scalar struct of fitSurrogate
%
% Kept: name, runs, levels, limits, trend, covariance, parameters. The factored
% covariance is computed again by loadSurrogate.
%
% Errors: DEcalioc:writeAtomic:cannotWrite

function saveSurrogate (file, surrogate)
  surrogate = mergeFields (surrogate, surrogate.model);
  surrogate.level = surrogate.extra;         % its name in the files
  for name = {'name', 'X', 'z', 'limits', 'level', 'noiseLaw', 'trend', ...
              'covariance', 'param', 'lognoisevariance', 'shift', 'scale', ...
              'scatter'}
    kept.(name{1}) = surrogate.(name{1});
  end
  writeAtomic (file, evalc ('save -text - kept'));
end

%!test
%! rand ('twister', 1);
%! X = rand (10, 2);
%! s = fitSurrogate (X, X * [1; 2], [0, 0; 1, 1]);
%! file = tempname ();
%! saveSurrogate (file, s);
%! r = loadSurrogate (file);
%! delete (file);
%! assert (predictSurrogate (r, X), predictSurrogate (s, X), 1e-9);
%! assert (r.Q2, s.Q2, 1e-9);

% SPDX-License-Identifier: GPL-3.0-only
