% UNITFACTOR  By what a value is multiplied to have another unit.
%
% CALL: FACTOR = unitFactor (FROM, TO)
%
%   FROM, TO  units (text): products and quotients of g, m, s, min, h, d, l, t,
%             N, Pa, bar, J, W, Hz, rad, deg, rpm, rev, %, ppm, in, ft, lb, psi
%             with a prefix (n u m c d h k M G) and an exponent: kg/m3, mm^3,
%             kg m-3, N*mm
%             TO may be SI: kg, m, s and rad
%   FACTOR    1 where the texts are the same or mean the same; 0 where both are
%             known and no factor leads from one to the other; NaN where one of
%             them is not known
%
% A unit is a factor and its exponents of kg, m, s and rad. A frequency in Hz or
% 1/min becomes an angular speed where the other unit speaks of turns (rpm).

function factor = unitFactor (from, to)
  factor = 1;
  if strcmp (strtrim (from), strtrim (to))
    return
  end
  [a, b] = deal (unitOf (from), unitOf (to));
  if strcmp (to, 'SI')
    factor = a.size;
    return
  end
  turn = b.powers(4) - a.powers(4);
  if (a.isTurn || b.isTurn) && abs (turn) == 1
    a.size = a.size * (2 * pi)^turn;
    a.powers(4) = b.powers(4);
  end
  factor = a.size / b.size;
  if ~isnan (factor) && ~isequal (a.powers, b.powers)
    factor = 0;
  elseif abs (factor - 1) < 1e-12
    factor = 1;
  end
end

% SIZE in SI (NaN: not known), POWERS of kg, m, s, rad.
function unit = unitOf (text)
  unit = struct ('size', 1, 'powers', zeros (1, 4), 'isTurn', false);
  [text, parts] = partsOf (text);
  for part = parts
    [size, powers] = symbolOf (part{1}{2});
    power = 1;
    if ~isempty (part{1}{3})
      power = str2double (part{1}{3});
    end
    if part{1}{1} == '/'
      power = -power;
    end
    unit.size = unit.size * size^power;
    unit.powers = unit.powers + power * powers;
    unit.isTurn = unit.isTurn || ...
                  any (strcmp (part{1}{2}, {'rpm', 'rps', 'rev', 'U', 'Hz'}));
  end
  if ~isempty (text)
    unit.size = NaN;
  end
end

% TEXT: what is no part of a unit; PARTS: 1 x n cell of {sign, symbol, power}.
function [text, parts] = partsOf (text)
  signs = {char([194, 178]), '2'; char([194, 179]), '3'; ...
           char([194, 181]), 'u'; char([206, 188]), 'u'; ...
           char([194, 176]), 'deg'; char([194, 183]), '*'; '**', '^'};
  for sign = signs'
    text = strrep (text, sign{:});
  end
  text = regexprep (strtrim (text), {'\s*([*/])\s*', '\s+'}, {'$1', '*'});
  text = ['*', text];
  pattern = '([*/])([A-Za-z]+|%|1|-)\^?((?:-?\d)?)(?=[*/]|$)';
  parts = regexp (text, pattern, 'tokens');
  text = regexprep (text, pattern, '');
end

function [size, powers] = symbolOf (text)
  % symbol and its other names, size, powers, whether it takes a prefix
  known = {'g|gram|grams', 1e-3, [1, 0, 0, 0], true; ...
           'm', 1, [0, 1, 0, 0], true; ...
           's|sec|second|seconds', 1, [0, 0, 1, 0], true; ...
           'min|mins|minute|minutes', 60, [0, 0, 1, 0], false; ...
           'h|hr|hrs|hour|hours', 3600, [0, 0, 1, 0], false; ...
           'd|day|days', 86400, [0, 0, 1, 0], false; ...
           'l|L|liter|litre', 1e-3, [0, 3, 0, 0], true; ...
           't', 1e3, [1, 0, 0, 0], false; ...
           'N', 1, [1, 1, -2, 0], true; ...
           'Pa', 1, [1, -1, -2, 0], true; ...
           'bar', 1e5, [1, -1, -2, 0], true; ...
           'J', 1, [1, 2, -2, 0], true; ...
           'W', 1, [1, 2, -3, 0], true; ...
           'Hz', 1, [0, 0, -1, 0], true; ...
           'rad', 1, [0, 0, 0, 1], true; ...
           'deg|degree|degrees|grad|Grad', pi / 180, [0, 0, 0, 1], false; ...
           'rev|U', 2 * pi, [0, 0, 0, 1], false; ...
           'rpm', pi / 30, [0, 0, -1, 1], false; ...
           'rps', 2 * pi, [0, 0, -1, 1], false; ...
           '1|-', 1, [0, 0, 0, 0], false; ...
           '%', 1e-2, [0, 0, 0, 0], false; ...
           'ppm', 1e-6, [0, 0, 0, 0], false; ...
           'in|inch', 0.0254, [0, 1, 0, 0], false; ...
           'ft', 0.3048, [0, 1, 0, 0], false; ...
           'lb|lbs', 0.45359237, [1, 0, 0, 0], false; ...
           'psi', 6894.757293168, [1, -1, -2, 0], false; ...
           'Kg|KG', 1, [1, 0, 0, 0], false; ...
           'kpa|KPa', 1e3, [1, -1, -2, 0], false};
  prefix = struct ('n', 1e-9, 'u', 1e-6, 'm', 1e-3, 'c', 1e-2, 'd', 0.1, ...
                   'h', 100, 'k', 1e3, 'M', 1e6, 'G', 1e9);
  isIt = @(t) cellfun (@(n) any (strcmp (t, strsplit (n, '|'))), known(:, 1));
  k = find (isIt (text));
  scale = 1;
  if isempty (k) && numel (text) > 1 && isfield (prefix, text(1))
    scale = prefix.(text(1));
    k = find (isIt (text(2:end)) & [known{:, 4}]');
  end
  [size, powers] = deal (NaN, zeros (1, 4));
  if ~isempty (k)
    [size, powers] = deal (scale * known{k, 2}, known{k, 3});
  end
end

%!test
%! for row = {'g', 'kg', 1e-3; 'mm', 'm', 1e-3; 'cm', 'm', 0.01; ...
%!            'ms', 's', 1e-3; 'min', 's', 60; 'h', 's', 3600; ...
%!            'kPa', 'Pa', 1e3; 'MPa', 'kPa', 1e3; 'mbar', 'Pa', 100; ...
%!            'mm3', 'm3', 1e-9; 'mm^3', 'm3', 1e-9; 'ml', 'cm3', 1; ...
%!            'l', 'm3', 1e-3; 'rpm', 'rad/s', pi / 30; '1/min', 'rpm', 1; ...
%!            'rad', 'deg', 180 / pi; 'g/cm3', 'kg/m3', 1000; ...
%!            'g/min', 'kg/s', 1e-3 / 60; 'kg m-3', 'g/l', 1; ...
%!            'Nmm', 'N m', NaN; 'N mm', 'J', 1e-3; '%', '-', 0.01; ...
%!            'U/min', 'rpm', 1; 'Hz', 'rad/s', 2 * pi; ...
%!            'grain', 'grain', 1; 'grain', 'g', NaN; 'kg', '%', 0; ...
%!            'm', 's', 0; '1/s', 'rad/s', 0; 'kg/m', 'kg', 0; '', 'm', NaN; ...
%!            't/h', 'kg/s', 1 / 3.6; 'J/m3', 'Pa', 1}'
%!   got = unitFactor (row{1:2});
%!   assert (got, row{3}, 1e-12 * abs (row{3}));
%! end
%!test
%! % as a spreadsheet has them: degree sign, superscript, micro, dot
%! assert (unitFactor (char ([194, 176]), 'rad'), pi / 180, 1e-15);
%! assert (unitFactor (['kg/m', char([194, 179])], 'g/cm3'), 1e-3, 1e-15);
%! assert (unitFactor ([char([194, 181]), 'm'], 'mm'), 1e-3, 1e-15);
%! assert (unitFactor (['N', char([194, 183]), 'm'], 'J'), 1);

% SPDX-License-Identifier: GPL-3.0-only
