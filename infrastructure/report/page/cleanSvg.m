% CLEANSVG  Makes a drawing of gnuplot a part of an HTML page.
%
% CALL: SVG = cleanSvg (TEXT, FIGURE)
%
%   TEXT    what gnuplot's terminal svg has written
%   FIGURE  see newFigure; its title and alt name the picture
%   SVG     one svg element without head, definitions, empty groups, names
%
% See also: drawFigures, houseSymbols

function svg = cleanSvg (text, f)
  body = regexp (text, '</defs>(.*)</svg>', 'tokens', 'once'){1};
  body = regexprep (body, '<title>[^<]*</title>', '');
  body = regexprep (body, ' id="[^"]*"', '');
  body = regexprep (body, '\s*\n\s*', "\n");
  was = '';
  while ~strcmp (was, body)
    was = body;
    body = regexprep (body, '<g [^>]*>\s*</g>', '');
  end
  body = strrep (body, 'xlink:href', 'href');
  body = regexprep (body, ' stroke-line(cap|join)="\w+"', '');
  body = regexprep (body, ' class="gridline"', '');
  body = withVariables (body);
  % the last group closes the canvas, which was opened before the definitions
  body = regexprep (body, '</g>\s*$', '', 'once');
  svg = sprintf (['<svg viewBox="0 0 %d %d" width="%d" height="%d" ', ...
                  'role="img" aria-label="%s"><title>%s</title>%s</svg>'], ...
                 f.size, f.size, htmlText (f.alt), htmlText (f.title), ...
                 strtrim (body));
end

function body = withVariables (body)
  colours = houseColours ();
  for name = fieldnames (colours)'
    rgb = sscanf (colours.(name{1}), '#%2x%2x%2x');
    form = sprintf ('rgb\\( *%d, *%d, *%d\\)', rgb);
    body = regexprep (body, form, sprintf ('var(--%s)', name{1}));
  end
  body = regexprep (body, '(fill|color|stroke)="black"', ...
                    '$1="var(--ink)"');
  body = strrep (body, 'color=''white''', 'color="var(--paper)"');
end

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'gnuplot'))
%! f = newFigure ('T<1>', 'mu ''x''', 'y `a`', 'a "line"');
%! f = addLayer (f, 'area', [0, 1, 2; 1, 2, 3], 'paleblue');
%! f = addLayer (f, 'line', [0, 1; 1, 2], 'blue');
%! f = addLayer (f, 'disc', [0, 1; 1, 2], 'red');
%! svg = drawFigures ([f, f]){2};
%! assert (! isempty (strfind (svg, 'aria-label="a &quot;line&quot;"')));
%! assert (! isempty (strfind (svg, 'var(--paleblue)')));
%! assert (! isempty (strfind (svg, 'mu ''x''')));
%! assert (isempty (strfind (svg, 'rgb(')));
%! opened = numel (regexp (svg, '<g[ >]'));
%! assert (numel (strfind (svg, '</g>')), opened);
%! % nothing in it: axes all the same
%! svg = drawFigures (newFigure ('T', 'x', 'y', 'a')){1};
%! assert (! isempty (strfind (svg, '<text>')));
