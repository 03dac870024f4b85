% AMOUNTIN  A number as a person types it, with or without a unit.
%
% CALL: [VALUE, FAULT] = amountIn (TEXT, UNIT)
%
%   TEXT   what was typed: '0.004', '4 mm', '' (nothing known)
%   UNIT   unit that is wanted, see unitFactor (text)
%   VALUE  text of the number in UNIT; '' where TEXT is empty; [] with a FAULT
%   FAULT  '' or what is needed, a sentence (text)

function [value, fault] = amountIn (text, unit)
  fault = '';
  text = strtrim (text);
  value = text;
  if isempty (text)
    return
  end
  parts = regexp (text, ['^([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)', ...
                         '(\s*[^\d\s,.].*)?$'], 'tokens', 'once');
  factor = 0;
  if numel (parts) == 1
    factor = 1;
  elseif numel (parts) == 2
    factor = unitFactor (parts{2}, unit);
    value = sprintf ('%.15g', factor * str2double (parts{1}));
  end
  if ~(abs (factor) > 0 && isfinite (str2double (value)))
    value = [];
    fault = sprintf (['a number in %s is needed, or one with its unit behind ' ...
                      'it, got ''%s''.'], unit, text);
    if any (text == ',')     % str2double would take 4,5 for 45
      fault = [fault, ' Its decimals stand behind a point.'];
    end
  end
end

%!test
%! for row = {'0.004', 'm', '0.004'; '2e-3', 'm', '2e-3'; '4 mm', 'm', '0.004'; ...
%!            '4mm', 'm', '0.004'; ' 2.6 g/cm3', 'kg/m3', '2600'; ...
%!            '', 'm', ''; '0 mm', 'm', '0'; '.5', 'm', '.5'; '4.', 'm', '4.'; ...
%!            '12 g', 'kg', '0.012'; '-3 deg', 'deg', '-3'; ...
%!            '2e-3 m', 'm', '0.002'}'
%!   [value, fault] = amountIn (row{1:2});
%!   assert ({value, fault}, {row{3}, ''});
%! end
%! for text = {'4 furlongs', '4 kg', 'four', '4,5', '4 5', '1e999', ...
%!              '4i', '-', 'NaN', '1e', '4,000 mm'}
%!   [value, fault] = amountIn (text{1}, 'mm');
%!   assert (isempty (value) && ~isempty (strfind (fault, ['''', text{1}])));
%! end
%! assert (~isempty (strfind (nthargout (2, @amountIn, '4,5', 'm'), 'point')));

% SPDX-License-Identifier: GPL-3.0-only
