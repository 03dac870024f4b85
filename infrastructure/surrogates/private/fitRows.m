% FITROWS  Kriging model of some of the runs of a response.
%
% CALL: S = fitRows (X, Z, EXTRA, USE, LIMITS, OPTIONS)
%
%   X, Z, LIMITS, OPTIONS  see fitSurrogate
%   EXTRA  n x 1, a further input, see fitSurrogate; may be []
%   USE  n x 1 logical, the runs of the fit
%   S    struct of fitSurrogate; EXTRA is an input where it differs, and
%        OPTIONS.trend gives way to one that so many runs and values can carry:
%        two values have a straight line between them and no square

function s = fitRows (X, z, extra, use, limits, options)
  X = X(use, :);
  if ~isempty (extra)
    options = withExtra (options, extra(use), columns (X));
  end
  s = fitSurrogate (X, z(use), limits, options);
end

function options = withExtra (options, extra, d)
  n = numel (extra);
  nValues = numel (unique (extra));
  options.extra = extra;
  if nValues < 2
    options.extra = [];
  end
  if ~isfield (options, 'trend')
    return
  end
  d = d + (nValues > 1);
  isRich = n >= 1.5 * (d + 1) * (d + 2) && nValues ~= 2;
  if strcmp (options.trend, 'quadratic') && ~isRich
    options.trend = 'affine';
  end
  if n < d + 4
    options.trend = 'constant';
  end
end

%!test
%! rand ('twister', 1);
%! X = rand (30, 2);
%! two = [ones(15, 1); zeros(15, 1)];
%! o = struct ('trend', 'quadratic', 'covariance', 'gauss');
%! fitted = @(extra, use, o) fitRows (X, X(:, 1) + extra, extra, use, ...
%!                                    [0, 0; 1, 1], o);
%! use = true (30, 1);
%! s = fitted (two, use, o);
%! assert ({s.trend, s.extra}, {'affine', two});
%! s = fitted (zeros (30, 1), use, o);
%! assert ({s.trend, s.extra}, {'quadratic', []});
%! use(1:24) = false;
%! assert (fitted (two, use, o).trend, 'affine');
%! assert (fitted (two, ~use & (1:30)' > 10 & (1:30)' < 17, o).trend, ...
%!         'constant');

% SPDX-License-Identifier: GPL-3.0-only
