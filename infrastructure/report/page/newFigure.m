% NEWFIGURE  A figure of the report, with nothing drawn in it yet.
%
% CALL: F = newFigure (TITLE, XLABEL, YLABEL, ALT)
%
%   TITLE           text above the figure
%   XLABEL, YLABEL  texts at the axes, with their units
%   ALT             what the figure shows, in a sentence, for those who cannot
%                   see it
%   F               scalar struct: also size (1 x 2, px), xlim, ylim (1 x 2,
%                   NaN: as the data want), xnames, ynames (cell of texts for
%                   positions 1, 2, ...; empty: numbers), xlog (false), caption
%                   (true: the title stands above it), whole (false; true:
%                   ticks of x at whole numbers), equal (false: scales
%                   of both axes may differ), layers

function f = newFigure (title, xlabel, ylabel, alt)
  f = struct ('title', title, 'xlabel', xlabel, 'ylabel', ylabel, ...
              'alt', alt, 'size', [340, 230], 'xlim', [NaN, NaN], ...
              'ylim', [NaN, NaN], 'xnames', {{}}, 'ynames', {{}}, ...
              'caption', true, 'xlog', false, 'whole', false, ...
              'equal', false, 'layers', []);
  f.layers = struct ('kind', {}, 'data', {}, 'colour', {});
end

%!assert (isempty (newFigure ('t', 'x', 'y', 'a').layers))
