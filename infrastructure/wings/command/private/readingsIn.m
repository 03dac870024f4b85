% READINGSIN  Several readings of one quantity as a person types them.
%
% CALL: [READINGS, FAULT] = readingsIn (TEXT, UNIT)
%
%   TEXT      what was typed: '31.4, 32.0, 30.6', '14,1; 13,9 g', '' (not measured)
%   UNIT      that of the result, see unitFactor (text)
%   READINGS  scalar struct: values (1 x n cell of texts, in unit), unit (the one
%             that was typed behind the last number, else UNIT); [] with a FAULT
%   FAULT     '' or what is needed, a sentence (text)
%
% Commas part numbers where a blank follows, or where the decimals have points;
% semicolons and blanks always do.
%
% See also: amountIn

function [readings, fault] = readingsIn (text, unit)
  fault = '';
  text = strtrim (text);
  readings = struct ('values', {cell(1, 0)}, 'unit', unit);
  if isempty (text)
    return
  end
  parts = regexp (text, '^(.*?[\d.])(\s*[^\d\s,.;][^\d,;]*\d?)?$', 'tokens', 'once');
  behind = '';
  if numel (parts) == 2
    [text, readings.unit] = deal (parts{1}, strtrim (parts{2}));
    behind = [' ', readings.unit];
  end
  for word = numbersOf (text)
    [~, fault] = amountIn ([word{1}, behind], unit);
    if ~isempty (fault)
      readings = [];
      return
    end
    readings.values{end + 1} = word{1};
  end
end

function words = numbersOf (text)
  mark = '\s+';
  if any (text == ';')
    mark = '\s*;\s*';
  elseif ~isempty (regexp (text, ',\s', 'once'))
    mark = '\s*,\s+';
  elseif any (text == '.') && any (text == ',')
    mark = ',';
  end
  words = regexp (text, mark, 'split');
  words = words(~cellfun (@isempty, words));
  if numel (words) > 1
    words = regexprep (words, '^([-+]?\d*),(\d+)$', '$1.$2');
  end
end

%!test
%! for row = {'31.4, 32.0, 30.6', 'deg', '31.4 32.0 30.6', 'deg'; ...
%!            '14,1; 13,9; 14,3 g', 'kg', '14.1 13.9 14.3', 'g'; ...
%!            '31,4 32,0', 'deg', '31.4 32.0', 'deg'; '31', 'deg', '31', 'deg'; ...
%!            '31.4,32', 'deg', '31.4 32', 'deg'; '0.6 rad', 'deg', '0.6', 'rad'; ...
%!            '690 kg/m3', 'kg/m3', '690', 'kg/m3'; '31,4, 32,0', 'deg', '31.4 32.0', 'deg'}'
%!   [r, fault] = readingsIn (row{1:2});
%!   assert ({strjoin(r.values, ' '), r.unit, fault}, [row(3:4)', {''}]);
%! end
%! assert (readingsIn ('', 'm').values, cell (1, 0));
%! for text = {'31,4', 'about 30', '31 kg', '31; x'}
%!   [r, fault] = readingsIn (text{1}, 'deg');
%!   assert (isempty (r) && ! isempty (fault), text{1});
%! end

% SPDX-License-Identifier: GPL-3.0-only
