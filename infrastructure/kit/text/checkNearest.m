% CHECKNEAREST  Finds the known name that a misspelt one probably means.
%
% CALL: HINT = checkNearest (NAME, KNOWN)
%
%   NAME   what was written (text)
%   KNOWN  cell of n known names
%   HINT   'Did you mean <name>?', or '' where none is near
%
% Near means an edit distance (insert, delete, replace one character, swap two
% neighbours; upper and lower case are the same) of at most a third of the
% name's length.

function hint = checkNearest (name, known)
  hint = '';
  if isempty (known) || numel (name) > 63
    return
  end
  distance = cellfun (@(k) editDistance (small (name), small (k)), known);
  [least, nearest] = min (distance);
  if least <= max (1, numel (name) / 3)
    hint = sprintf ('Did you mean %s?', known{nearest});
  end
end

function text = small (text)
  capital = text >= 'A' & text <= 'Z';
  text(capital) = text(capital) + 32;
end

% Row by row: d(j+1) is the distance of the first i characters of a to the
% first j of b.
function n = editDistance (a, b)
  [above, d] = deal (0:numel (b));
  for i = 1:numel (a)
    [before, above] = deal (above, d);
    d(1) = i;
    for j = 1:numel (b)
      d(j + 1) = min ([above(j + 1) + 1, d(j) + 1, above(j) + (a(i) ~= b(j))]);
      if i > 1 && j > 1 && a(i) == b(j - 1) && a(i - 1) == b(j)
        d(j + 1) = min (d(j + 1), before(j - 1) + 1);
      end
    end
  end
  n = d(end);
end

%!assert (checkNearest ('timout', {'seed', 'timeout'}), ...
%!        'Did you mean timeout?')
%!assert (checkNearest ('DENSITYp', {'radiusP', 'densityP'}), ...
%!        'Did you mean densityP?')
%!assert (checkNearest ('colour', {'radiusP', 'densityP'}), '')
%!assert (checkNearest ('laebl', {'name', 'label'}), 'Did you mean label?')
%!assert (checkNearest ('a', {}), '')

% SPDX-License-Identifier: GPL-3.0-only
