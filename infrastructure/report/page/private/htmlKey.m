% HTMLKEY  What the symbols and colours of figures mean, as HTML.
%
% CALL: HTML = htmlKey (ENTRIES)
%
%   ENTRIES  n x 3 cell: kind of layer (see newFigure), colour, meaning (HTML)

function html = htmlKey (entries)
  items = cellfun (@(kind, colour, meaning) ['<li><svg viewBox="0 0 26 14" width="26" ', ...
                                             'height="14" aria-hidden="true">', ...
                                             sample(kind, colour), '</svg> ', meaning, ...
                                             '</li>'], ...
                   entries(:, 1), entries(:, 2), entries(:, 3), 'UniformOutput', false);
  html = ['<ul class="key" aria-label="Key of the figures">', items{:}, "</ul>\n"];
end

function svg = sample (kind, colour)
  known = struct ('area', [1, 2, 12; 25, 2, 12], 'box', [1, 2, 1, 25, 2, 12], ...
                  'line', [1, 7; 25, 7], 'dash', [1, 7; 25, 7], 'xbar', [13, 7, 3, 23], ...
                  'ybar', [13, 7, 1, 13]);
  svg = layerSvg (kind, givenField (known, kind, [13, 7]), colour, @(x) x, @(y) y){1};
end

%!test
%! html = htmlKey ({'area', 'blue', 'a'; 'disc', 'red', 'b'; ...
%!                  'xbar', 'red', 'c'; 'dash', 'ink', 'd'});
%! assert (numel (strfind (html, '<li>')), 4);
%! assert (! isempty (strfind (html, 'var(--red)')));

% SPDX-License-Identifier: GPL-3.0-only
