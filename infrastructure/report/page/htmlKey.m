% HTMLKEY  What the symbols and colours of figures mean, as HTML.
%
% CALL: HTML = htmlKey (ENTRIES)
%
%   ENTRIES  n x 3 cell: kind of layer (see newFigure), colour, meaning (HTML)

function html = htmlKey (entries)
  items = cell (1, rows (entries));
  for k = 1:rows (entries)
    items{k} = ['<li><svg viewBox="0 0 26 14" width="26" height="14" ', ...
                'aria-hidden="true">', sample(entries{k, 1:2}), ...
                '</svg> ', entries{k, 3}, '</li>'];
  end
  html = ['<ul class="key" aria-label="Key of the figures">', items{:}, ...
          "</ul>\n"];
end

function svg = sample (kind, colour)
  drawn = ['"var(--', colour, ')"/>'];
  switch kind
    case {'area', 'box'}
      svg = ['<rect x="1" y="2" width="24" height="10" fill=', drawn];
    case 'line'
      svg = ['<path d="M1 7h24" stroke-width="2" stroke=', drawn];
    case 'dash'
      svg = ['<path d="M1 7h24" stroke-width="1.5" stroke-dasharray="6 4" ', ...
             'stroke=', drawn];
    otherwise
      symbols = struct ('dots', 6, 'disc', 6, 'ring', 5, 'diamond', 12, ...
                        'triangle', 8, 'xbar', 6, 'ybar', 6);
      svg = sprintf (['<use href="#gpPt%d" color="var(--%s)" transform=', ...
                      '"translate(13,7) scale(%d)"/>'], symbols.(kind), ...
                     colour, 4 - 2 * strcmp (kind, 'dots'));
      if any (strcmp (kind, {'xbar', 'ybar'}))
        svg = ['<path d="M3 7h20M3 4v6M23 4v6" stroke-width="1.5" ', ...
               'stroke=', drawn, svg];
      end
  end
end

%!test
%! html = htmlKey ({'area', 'blue', 'a'; 'disc', 'red', 'b'; ...
%!                  'xbar', 'red', 'c'; 'dash', 'ink', 'd'});
%! assert (numel (strfind (html, '<li>')), 4);
%! assert (! isempty (strfind (html, 'var(--red)')));
