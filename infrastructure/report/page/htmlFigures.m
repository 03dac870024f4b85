% HTMLFIGURES  Figures side by side, as many as the screen has room for.
%
% CALL: HTML = htmlFigures (FIGURES, KEY, CLASS)
%
%   FIGURES  1 x n struct array, see newFigure
%   KEY      HTML of htmlKey, or ''
%   CLASS    how wide: 'panels' (default), 'pairs', 'wide'

function html = htmlFigures (figures, key, class)
  html = '';
  if isempty (figures)
    return
  end
  if nargin < 3
    class = 'panels';
  end
  svgs = drawFigures (figures);
  parts = cell (1, numel (figures));
  for k = 1:numel (figures)
    caption = '';
    if figures(k).caption
      caption = ['<figcaption>', htmlText(figures(k).title), '</figcaption>'];
    end
    parts{k} = ['<figure>', caption, svgs{k}, "</figure>\n"];
  end
  scroll = '';
  if strcmp (class, 'wide')
    scroll = ' role="region" tabindex="0" aria-label="Figure"';
  end
  html = [key, '<div class="', class, '"', scroll, '>', parts{:}, ...
          "</div>\n"];
end

%!assert (htmlFigures ([], ''), '')
