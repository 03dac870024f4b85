% FITROWS  Kriging model of some of the runs of a response.
%
% CALL: S = fitRows (X, Z, LEVEL, USE, LIMITS, OPTIONS)
%
%   X, Z, LEVEL, LIMITS, OPTIONS  see fitLevels; LEVEL may be []
%   USE  n x 1 logical, the runs of the fit
%   S    struct of fitSurrogate; the level is an input where it differs, and
%        OPTIONS.trend gives way to one that so many runs and levels can carry:
%        two levels have a straight line between them and no square

function s = fitRows (X, z, level, use, limits, options)
  X = X(use, :);
  if ~isempty (level)
    options = withLevel (options, level(use), columns (X));
  end
  s = fitSurrogate (X, z(use), limits, options);
end

function options = withLevel (options, level, d)
  n = numel (level);
  nLevels = numel (unique (level));
  options.level = level;
  if nLevels < 2
    options.level = [];
  end
  if ~isfield (options, 'trend')
    return
  end
  d = d + (nLevels > 1);
  isRich = n >= 1.5 * (d + 1) * (d + 2) && nLevels ~= 2;
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
%! fitted = @(level, use, o) fitRows (X, X(:, 1) + level, level, use, ...
%!                                    [0, 0; 1, 1], o);
%! use = true (30, 1);
%! s = fitted (two, use, o);
%! assert ({s.trend, s.level}, {'affine', two});
%! s = fitted (zeros (30, 1), use, o);
%! assert ({s.trend, s.level}, {'quadratic', []});
%! use(1:24) = false;
%! assert (fitted (two, use, o).trend, 'affine');
%! assert (fitted (two, ~use & (1:30)' > 10 & (1:30)' < 17, o).trend, ...
%!         'constant');
