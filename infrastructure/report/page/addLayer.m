% ADDLAYER  Draws something on top of what a figure shows so far.
%
% CALL: F = addLayer (F, KIND, DATA, COLOUR)
%
%   F       see newFigure
%   KIND    'area' (columns x, low, high), 'box' (x, y, xlo, xhi, ylo, yhi),
%           'line', 'dash', 'dots', 'disc', 'ring', 'diamond', 'cross',
%           'square', 'triangle' (x, y), 'xbar', 'ybar' (x, y, low, high)
%   DATA    n x k; rows that are not finite are left out
%   COLOUR  name of a colour, see drawFigures
%
% Errors: DEcalioc:addLayer:badShape

function f = addLayer (f, kind, data, colour)
  wanted = 2;
  if strcmp (kind, 'area')
    wanted = 3;
  elseif any (strcmp (kind, {'xbar', 'ybar'}))
    wanted = 4;
  elseif strcmp (kind, 'box')
    wanted = 6;
  end
  if columns (data) ~= wanted
    error ('DEcalioc:addLayer:badShape', ...
           'addLayer: DATA of %s must have %d columns, got %d.', kind, ...
           wanted, columns (data));
  end
  data = data(all (isfinite (data), 2), :);
  if ~isempty (data)
    f.layers(end + 1) = struct ('kind', kind, 'data', data, ...
                                'colour', colour);
  end
end

%!test
%! f = newFigure ('t', 'x', 'y', 'a');
%! f = addLayer (f, 'line', [1, 2; NaN, 3; 4, 5], 'blue');
%! assert (f.layers.data, [1, 2; 4, 5]);
%! assert (numel (addLayer (f, 'dots', [NaN, 1], 'red').layers), 1);
%!error id=DEcalioc:addLayer:badShape
%! addLayer (newFigure ('', '', '', ''), 'area', [1, 2], 'blue');
