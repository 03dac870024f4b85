% NEWFIGURE  A figure of the report.
%
% CALL: F = newFigure (TITLE, XLABEL, YLABEL, ALT, LAYERS)
%
%   TITLE   text above the figure
%   XLABEL  text at the axis, with its unit
%   YLABEL  the same; or 1 x n cell: names of rows, from the top, which lie at
%           y = n, n - 1, ... 1
%   ALT     what the figure shows, in a sentence, for those who cannot see it
%   LAYERS  m x 3 cell, from the back (default none): kind, data, colour of
%           page.css. Kinds and the columns of their data: 'area' (x, low,
%           high), 'box' (x, y, xlo, xhi, ylo, yhi), 'xbar', 'ybar' (x, y, low,
%           high), and with x, y: 'line', 'dash', 'dots', 'disc', 'ring',
%           'diamond', 'triangle'. Rows that are not finite are left out
%   F       scalar struct: these; size (1 x 2, px), xlim, ylim (1 x 2, NaN: as
%           the data want), ynames, caption (true: the title stands above it),
%           whole (true: ticks of x at whole numbers alone), xlog, ylog (true:
%           a logarithmic axis; xlim, ylim are positive then), place ([] or row and
%           column in a corner plot)

function f = newFigure (title, xlabel, ylabel, alt, layers)
  f = struct ('title', title, 'xlabel', xlabel, 'ylabel', '', 'alt', alt, ...
              'size', [340, 230], 'xlim', [NaN, NaN], 'ylim', [NaN, NaN], ...
              'ynames', {{}}, 'caption', true, 'whole', false, ...
              'xlog', false, 'ylog', false, 'place', [], ...
              'layers', {cell(0, 3)});
  if nargin > 4
    f.layers = layers;
  end
  if iscell (ylabel)
    f.ynames = fliplr (ylabel(:)');
    f.ylim = [0.4, numel(ylabel) + 0.6];
  else
    f.ylabel = ylabel;
  end
end

%!test
%! f = newFigure ('t', 'x', {'first', 'second'}, 'a');
%! assert (f.ynames, {'second', 'first'});
%! assert (f.ylim, [0.4, 2.6]);
%! assert (isempty (f.layers));

% SPDX-License-Identifier: GPL-3.0-only
