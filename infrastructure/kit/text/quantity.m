% QUANTITY  A value with its unit as one says it, and its interval.
%
% CALL: TEXT = quantity (X, UNIT, RANGE, WORD)
%
%   X      scalar
%   UNIT   text, SI; '' or '-': a plain number
%   RANGE  1 x 2, optional: ' (from to)' is added unless it is not finite
%   WORD   text, optional: what the range is, said before it: 'allowed '
%   TEXT   '41.9 kJ/m3 (25.9 to 60)'; '1.5 mm'; '-' where X is not finite
%
% Prefixes are taken where the unit begins with one that takes them. Three
% digits.

function text = quantity (x, unit, range, word)
  if nargin < 4
    word = '';
  end
  text = '-';
  if isempty (x) || ~isfinite (x)
    return
  end
  if strcmp (unit, '-')
    unit = '';
  end
  [factor, unit] = prefixed (x, unit);
  text = strtrim ([number(x / factor), ' ', unit]);
  if nargin > 2 && numel (range) == 2 && all (isfinite (range))
    text = sprintf ('%s (%s%s to %s)', text, word, ...
                    number (range(1) / factor), number (range(2) / factor));
  end
end

function [factor, unit] = prefixed (x, unit)
  factor = 1;
  if any (strcmp (unit, {'kg', 'kg/s'}))
    unit = unit(2:end);
    factor = 1e-3;
  elseif strcmp (unit, 'm3') && abs (x) < 1e-3
    [factor, unit] = deal (1e-6, 'cm3');
    return
  elseif ~any (strcmp (strtok (unit, '/'), {'J', 'Pa', 'N', 'W', 'm', 's'}))
    return
  end
  size = abs (x) / factor;
  if size == 0
    [factor, unit] = deal (1, strrep (unit, 'g', 'kg'));
    return
  end
  power = 3 * floor (log10 (size * (1 + 1e-9)) / 3);
  if any (strcmp (strtok (unit, '/'), {'m', 's'}))
    power = min (power, 0);          % hours and kilometres are no such numbers
  end
  power = min (max (power, -6), 9);
  names = {'u', 'm', '', 'k', 'M', 'G'};
  unit = [names{power / 3 + 3}, unit];
  factor = factor * 10^power;
end

function text = number (x)
  text = sprintf ('%.3g', x);
  if abs (x) >= 1000 && abs (x) < 1e6
    text = sprintf ('%.0f', x);
  end
end

%!assert (quantity (42059, 'J/m3', [26000, 60000]), '42.1 kJ/m3 (26 to 60)')
%!assert (quantity (0.00153, 'm'), '1.53 mm')
%!assert (quantity (0.0121, 'kg'), '12.1 g')
%!assert (quantity (2.8e-5, 'm3'), '28 cm3')
%!assert (quantity (1250, 'kg/m3'), '1250 kg/m3')
%!assert (quantity (-1.5, 'deg', [-2, -0.5]), '-1.5 deg (-2 to -0.5)')
%!assert (quantity (0.5243, '-', [NaN, 1]), '0.524')
%!assert (quantity (NaN, 'm'), '-')
%!assert (quantity (0, 'kg'), '0 kg')
%!assert (quantity (1234, ''), '1234')
%!assert (quantity (6, 'N', [5.7, 6.3], 'allowed '), '6 N (allowed 5.7 to 6.3)')

% SPDX-License-Identifier: GPL-3.0-only
