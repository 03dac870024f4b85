% HTMLFIGURES  Figures side by side, as many as the screen has room for.
%
% CALL: HTML = htmlFigures (FIGURES, KEY, CLASS)
%
%   FIGURES  1 x n struct array, see newFigure
%   KEY      entries of htmlKey, optional
%   CLASS    how wide: 'panels' (default), 'pairs', 'wide', 'one', 'corner' (each
%            at its place)
%   HTML     SVG elements (figureSvg) with their captions, below the key

function html = htmlFigures (figures, key, class)
  html = '';
  if isempty (figures)
    return
  end
  if nargin < 3
    class = 'panels';
  end
  if nargin > 1 && ~isempty (key)
    html = htmlKey (key);
  end
  scroll = repmat (' role="region" tabindex="0" aria-label="Figure"', 1, ...
                   strcmp (class, 'wide'));
  html = [html, '<div class="', class, '"', scroll, '>'];
  for f = figures
    place = repmat (sprintf (' style="grid-area:%d/%d"', f.place), 1, ~isempty (f.place));
    caption = ['<figcaption>', htmlText(f.title), '</figcaption>'];
    html = [html, '<figure', place, '>', repmat(caption, 1, f.caption), figureSvg(f), ...
            "</figure>\n"];
  end
  html = [html, "</div>\n"];
end

%!test
%! f = newFigure ('T', 'x', 'y', 'a', {'line', [0, 1; 1, 2], 'blue'});
%! html = htmlFigures ([f, f], {'line', 'blue', 'b'}, 'wide');
%! assert (numel (strfind (html, '<figure>')), 2);
%! assert (numel (strfind (html, '<figcaption>T</figcaption>')), 2);
%! assert (! isempty (strfind (html, 'tabindex="0"')));
%! [f.place, f.caption] = deal ([1, 2], false);
%! assert (! isempty (strfind (htmlFigures (f), '<figure style="grid-area:1/2"><svg')));
%! assert (htmlFigures ([]), '');

% SPDX-License-Identifier: GPL-3.0-only
