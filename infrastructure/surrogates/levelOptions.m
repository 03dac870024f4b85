% LEVELOPTIONS  Options of a fit to some of the runs of a response with levels.
%
% CALL: OPTIONS = levelOptions (OPTIONS, LEVEL, D)
%
%   OPTIONS  of fitSurrogate
%   LEVEL    n x 1, how coarse the runs of the fit are (unitLevel); may be empty
%   D        number of parameters
%   OPTIONS  with level ([] where the runs are all of one level) and a trend
%            that so many runs and levels can carry: two levels have a straight
%            line between them and no square

function options = levelOptions (options, level, d)
  n = numel (level);
  nLevels = numel (unique (level));
  options.level = level;
  if nLevels < 2
    options.level = [];
  end
  if ~isfield (options, 'trend') || n == 0
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
%! o = struct ('trend', 'quadratic');
%! assert (levelOptions (o, [], 2), setfield (o, 'level', []));
%! assert (levelOptions (o, zeros (30, 1), 2), setfield (o, 'level', []));
%! two = [ones(15, 1); zeros(15, 1)];
%! assert (levelOptions (o, two, 2), struct ('trend', 'affine', 'level', two));
%! assert (levelOptions (o, [1; 0], 2).trend, 'constant');
%! assert (levelOptions (struct (), two, 2), struct ('level', two));
