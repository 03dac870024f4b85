% READINGSIN  Several readings of one quantity as a person types them.
%
% CALL: [READINGS, FAULT, ECHO] = readingsIn (TEXT, UNIT)
%
%   TEXT      what was typed: '31.4, 32.0, 30.6', '14,1; 13,9 g', '38.2 +- 0.5',
%             '' (not measured)
%   UNIT      that of the result, see unitFactor (text)
%   READINGS  scalar struct: values, sd (1 x n cells of texts, in unit; sd '' where none
%             was typed), unit (the first that was typed, else UNIT); [] with a FAULT
%   FAULT     '' or what is needed, a sentence (text)
%   ECHO      as what readings without a unit, or with an sd, are taken, else '' (text)
%
% One unit counts for all readings, or each has its own.
%
% Commas part numbers where a blank follows, or where the decimals have points;
% semicolons and blanks always do.
%
% See also: amountIn

function [readings, fault, echo] = readingsIn (text, unit)
  [fault, echo] = deal ('');
  [plain, sd] = withoutSd (strtrim (text));
  [words, units] = partsOf (plain);
  isTyped = ~isempty (units);
  if numel (units) < 2
    units = repmat ([units, repmat({unit}, 1, ~isTyped)], 1, numel (words));
  end
  isGiven = ~isempty (sd);
  if ~isGiven
    sd = repmat ({''}, size (words));
  end
  readings = struct ('values', {words}, 'sd', {sd}, 'unit', [units, {unit}]{1});
  needed = {'one unit for all readings or one for each', ...
            'an uncertainty behind each reading or none'};
  needed = needed([numel(units), numel(sd)] ~= numel (words));
  if ~isempty (needed)
    fault = sprintf ('%s is needed, got ''%s''.', needed{1}, text);
  end
  for k = 1:numel (words) * isempty (fault)
    behind = repmat ([' ', units{k}], 1, isTyped && ~isnan (str2double (words{k})));
    [~, fault] = amountIn ([words{k}, behind], unit);
    if ~isempty (fault)
      break
    end
    times = unitFactor (units{k}, unit) / unitFactor (readings.unit, unit);
    if times ~= 1
      [readings.values{k}, readings.sd{k}] = deal (timesText (words{k}, times), ...
                                                   timesText (sd{k}, times));
    end
  end
  if ~isempty (fault)
    readings = [];
  elseif isGiven
    echo = [strjoin(strcat (readings.values, {' +- '}, readings.sd), ', '), ' ', ...
            readings.unit, ' (standard uncertainty)'];
  elseif ~isempty (words) && ~isTyped
    [~, ~, echo] = amountIn (words{end}, unit);
    echo = strjoin ([words(1:end - 1), {echo}], ', ');
  end
end

function text = timesText (text, factor)
  if ~isempty (text)
    text = sprintf ('%.12g', factor * str2double (text));
  end
end

% What stands behind +- is the uncertainty of the reading before it.
function [text, sd] = withoutSd (text)
  mark = ['\s*(?:\+/?-|', "\302\261", ')\s*(\d*[.,]?\d+)'];
  sd = regexp (text, mark, 'tokens');
  if ~isempty (sd)
    sd = strrep ([sd{:}], ',', '.');
    text = regexprep (text, {mark, '[()]'}, '');
  end
end

% Numbers and the units behind them; where each has its own, they part the numbers.
function [words, units] = partsOf (text)
  pattern = ['(?<=[\d.])\s*(?![eE][-+]?\d)((?:(?<=\s)1/)?[^\d\s,.;+-][^\d,;]*?', ...
             '(?:\d(?![\d.]))?)\s*(?=[,;]|$|\s[-+\d.])'];
  units = regexp (text, pattern, 'tokens');
  units = [cell(1, 0), units{:}];
  if isscalar (units)
    text = regexprep (text, pattern, '');
  else
    text = regexprep (text, [pattern, '[,;]?'], ';');
  end
  words = numbersOf (text);
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
  words = [cell(1, 0), words(~cellfun (@isempty, words))];
  decimals = '(\d+)';
  if isscalar (words)            % 4,000 alone may be either
    decimals = '(\d{1,2}|\d{4,})';
  end
  words = regexprep (words, ['^([-+]?\d*),', decimals, '$'], '$1.$2');
end

%!test
%! for row = {'31.4, 32.0, 30.6', 'deg', '31.4 32.0 30.6', 'deg'; ...
%!            '14,1; 13,9; 14,3 g', 'kg', '14.1 13.9 14.3', 'g'; ...
%!            '31,4 32,0', 'deg', '31.4 32.0', 'deg'; '31', 'deg', '31', 'deg'; ...
%!            '31.4,32', 'deg', '31.4 32', 'deg'; '0.6 rad', 'deg', '0.6', 'rad'; ...
%!            '690 kg/m3', 'kg/m3', '690', 'kg/m3'; '31,4, 32,0', 'deg', '31.4 32.0', 'deg'; ...
%!            '13.7 g, 13.5 g, 13.6 g', 'kg', '13.7 13.5 13.6', 'g'; ...
%!            '13,7g, 13,5g', 'kg', '13.7 13.5', 'g'; '14g,13g', 'kg', '14 13', 'g'; ...
%!            '13.7 g 0.0135 kg', 'kg', '13.7 13.5', 'g'; '', 'm', '', 'm'; ...
%!            '690 kg/m3; 0.7 g/cm3', 'kg/m3', '690 700', 'kg/m3'; ...
%!            '2e-3 kg, 3e-3 kg', 'kg', '2e-3 3e-3', 'kg'; ...
%!            '2e-3, 3e-3', 'kg', '2e-3 3e-3', 'kg'; ...
%!            '13.7 g, 13.5, 13.6', 'kg', '13.7 13.5 13.6', 'g'; ...
%!            '2 kg m-3 3 kg m-3', 'kg/m3', '2 3', 'kg m-3'; ...
%!            '5 1/m, 4 1/m', '1/m', '5 4', '1/m'; '5, 4 1/m', '1/m', '5 4', '1/m'; ...
%!            '31 1', 'deg', '31 1', 'deg'; ...
%!            '-17 mm, -16 mm', 'm', '-17 -16', 'mm'; '12 %', '-', '12', '%'}'
%!   [r, fault] = readingsIn (row{1:2});
%!   assert ({strjoin(r.values, ' '), r.unit, fault}, [row(3:4)', {''}]);
%! end
%! assert (readingsIn ('', 'm').values, cell (1, 0));
%! assert (readingsIn ('31,4 deg', 'deg').values, {'31.4'});
%! for text = {'31,400', 'about 30', '31 kg', '31; x', '31 deg, 32, 0.5 rad', ...
%!             '31 deg, 32 kg', '31 deg; 32; 0.5 rad'}
%!   [r, fault] = readingsIn (text{1}, 'deg');
%!   assert (isempty (r) && ! isempty (fault), text{1});
%! end
%!test
%! % a mean and its uncertainty, in the unit behind both
%! for row = {'38.2 +- 0.5', 'deg', '38.2|0.5|deg|', '38.2 +- 0.5 deg (standard uncertainty)'; ...
%!            ["38.2 \302\261 0.5 deg"], 'deg', '38.2|0.5|deg|', ...
%!            '38.2 +- 0.5 deg (standard uncertainty)'; ...
%!            '(13.7 +/- 0.2) g', 'kg', '13.7|0.2|g|', '13.7 +- 0.2 g (standard uncertainty)'; ...
%!            '13.7 +- 0.2 g; 0.0135 +- 0.0003 kg', 'kg', '13.7 13.5|0.2 0.3|g|', ...
%!            '13.7 +- 0.2, 13.5 +- 0.3 g (standard uncertainty)'}'
%!   [r, fault, echo] = readingsIn (row{1:2});
%!   assert ([strjoin(r.values, ' '), '|', strjoin(r.sd, ' '), '|', r.unit, '|', fault], row{3});
%!   assert (echo, row{4});
%! end
%! assert (readingsIn ('31', 'deg').sd, {''});
%! assert (readingsIn ('38,2 +- 0,5', 'deg').sd, {'0.5'});
%! for text = {'38.2 +- 0.5, 38.4', '38.2 +- x'}
%!   assert (isempty (readingsIn (text{1}, 'deg')), text{1});
%! end
%!test
%! % what is taken is said; what a balance cannot mean is asked for again
%! assert (nthargout (3, @readingsIn, '31,4 32', 'deg'), '31.4, 32 deg');
%! assert (nthargout (3, @readingsIn, '31 deg', 'deg'), '');
%! assert (nthargout (2, @readingsIn, '13.7, 13.5', 'kg'), '13.7 kg? Give a unit, such as 13.7 g.');
%! assert (isempty (strfind (nthargout (2, @readingsIn, '13.7 g, x g', 'kg'), 'g g')));

% SPDX-License-Identifier: GPL-3.0-only
