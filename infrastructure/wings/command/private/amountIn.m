% AMOUNTIN  A number as a person types it, with or without a unit.
%
% CALL: [VALUE, FAULT, ECHO] = amountIn (TEXT, UNIT)
%
%   TEXT   what was typed: '0.004', '4 mm', '' (nothing known)
%   UNIT   unit that is wanted, see unitFactor (text; '1' or '-' of a share)
%   VALUE  text of the number in UNIT; '' where TEXT is empty; [] with a FAULT
%   FAULT  '' or what is needed, a sentence (text)
%   ECHO   as what a number without a unit is taken, '' of another (text)
%
% A number without a unit that no grain and no rig on a table has is not taken: 4 was
% meant as 4 mm. A share ('1') is 1 at most.

function [value, fault, echo] = amountIn (text, unit)
  [fault, echo] = deal ('');
  % 4,5 is 4.5; 4,000 may be either
  text = regexprep (strtrim (text), '^([-+]?\d+),(\d{1,2}|\d{4,})(?![\d.,])', '$1.$2');
  value = text;
  if isempty (text)
    return
  end
  parts = regexp (text, ['^([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)', ...
                         '(\s*[^\d\s,.].*|\s+1/\D.*)?$'], 'tokens', 'once');
  factor = 0;
  if numel (parts) == 1
    factor = 1;
    [fault, echo] = ofBare (text, unit);
  elseif numel (parts) == 2
    factor = unitFactor (strrep (parts{2}, 'turns per minute', 'rpm'), unit);
    value = sprintf ('%.15g', factor * str2double (parts{1}));
  end
  if ~(abs (factor) > 0 && isfinite (str2double (value)))
    fault = sprintf (['a number%s is needed, or one with its unit behind ' ...
                      'it, got ''%s''.'], inUnit ([' in ', unit]), text);
    if any (text == ',')     % str2double would take 4,5 for 45
      fault = [fault, ' Its decimals stand behind a point.'];
    end
  end
  if ~isempty (fault)
    [value, echo] = deal ([], '');
  end
end

% The bands are those of inputGates, of what stands on a table.
function [fault, echo] = ofBare (text, unit)
  fault = '';
  echo = [text, inUnit([' ', unit])];
  % unit, least, most, the unit that was meant
  for row = {'m', 0, 0.5, 'mm'; 'kg', 0, 1, 'g'; 'm/s', 0, 2, 'mm/s'; ...
             'kg/m3', 50, 23000, 'g/cm3'; '1', 0, 1, '%'}'
    size = abs (str2double (text));
    if strcmp (unit, row{1}) && size > 0 && (size < row{2} || size > row{3})
      fault = sprintf ('%s? Give a unit, such as %s %s.', echo, text, row{4});
    end
  end
end

function text = inUnit (text)
  text = regexprep (text, {'\s*( in)? [1-]?$', ' rpm$'}, {'', ' turns per minute'});
end

%!test
%! for row = {'0.004', 'm', '0.004'; '2e-3', 'm', '2e-3'; '4 mm', 'm', '0.004'; ...
%!            '4mm', 'm', '0.004'; ' 2.6 g/cm3', 'kg/m3', '2600'; ...
%!            '', 'm', ''; '0 mm', 'm', '0'; '.5', 'm', '.5'; '4.', 'deg', '4.'; ...
%!            '12 g', 'kg', '0.012'; '-3 deg', 'deg', '-3'; ...
%!            '2e-3 m', 'm', '0.002'; ...
%!            '36.7 %', '1', '0.367'; '5 %', '-', '0.05'; '1.3', '-', '1.3'; ...
%!            '12 1/min', 'rpm', '12'; '5 1/m', '1/m', '5'; '12 turns per minute', 'rpm', '12'; ...
%!            '0.8 m', 'm', '0.8'}'
%!   [value, fault] = amountIn (row{1:2});
%!   assert ({value, fault}, {row{3}, ''});
%! end
%! for text = {'4 furlongs', '4 kg', 'four', '4,500', '4 5', '1e999', ...
%!              '4i', '-', 'NaN', '1e', '4,000 mm'}
%!   [value, fault] = amountIn (text{1}, 'mm');
%!   assert (isempty (value) && ~isempty (strfind (fault, ['''', text{1}])));
%! end
%! assert (~isempty (strfind (nthargout (2, @amountIn, '4,500', 'm'), 'point')));
%! assert (amountIn ('4,5 mm', 'm'), '0.0045');
%! assert (nthargout (3, @amountIn, '0,25', 'm'), '0.25 m');
%!test
%! % without a unit, what no table holds is asked for again, the rest is said
%! for row = {'4', 'm', '4 m? Give a unit, such as 4 mm.', ''; ...
%!            '23', 'kg', '23 kg? Give a unit, such as 23 g.', ''; ...
%!            '36.7', '1', '36.7? Give a unit, such as 36.7 %.', ''; ...
%!            '1.2', 'kg/m3', '1.2 kg/m3? Give a unit, such as 1.2 g/cm3.', ''; ...
%!            '0.036', 'm', '', '0.036 m'; '-0.01', 'm', '', '-0.01 m'; ...
%!            '10', 'rpm', '', '10 turns per minute'; '0.4', '-', '', '0.4'; ...
%!            '36 mm', 'm', '', ''; '', 'm', '', ''; ...
%!            'x', '1', 'a number is needed, or one with its unit behind it, got ''x''.', ''}'
%!   [~, fault, echo] = amountIn (row{1:2});
%!   assert ({fault, echo}, row(3:4)');
%! end

% SPDX-License-Identifier: GPL-3.0-only
