% CLEARNUMBERS  Numbers as people write them, with a point and no other marks.
%
% CALL: FIELDS = clearNumbers (FIELDS, WHERE, BYCOMMA)
%
%   FIELDS  n x 1 cell of texts; what is no number is left as it is
%   WHERE   handle that gives the place of field k, for the error
%   BYCOMMA  logical: commas part the columns, so a quoted 1,234 alone is
%           unclear, too
%
% Decimal commas become points; 1.234,5 and 1,234.5 and 1 234,5 and 1'234.5 lose
% their thousand marks; 1.5D-3 becomes 1.5e-3, a minus sign of print a hyphen.
% What may be a thousand or a decimal is taken as the other numbers of the table
% say.
%
% Errors: DEcalioc:readCsvTable:unclearPoint (1.002 beside decimal commas, 1,002
% beside decimal points)

function fields = clearNumbers (fields, where, byComma)
  text = [fields{:}];
  if any (text == char (226))
    minus = char ([226, 136, 146]);
    fields = regexprep (fields, ['^', minus, '(?=[\d.,])'], '-');
    fields = strrep (fields, char ([226, 128, 153]), '''');
  end
  if any (text == ' ' | text == '''')
    isMarked = isLike (fields, '[-+]?\d{1,3}([ '']\d{3})+([.,]\d*)?');
    fields(isMarked) = regexprep (fields(isMarked), '[ '']', '');
    fields = regexprep (fields, '^''([-+.,\deE]+)''$', '$1');
  end
  if ~isempty (regexp (text, '\d[dD][-+]?\d', 'once'))
    isFortran = isLike (fields, '[-+]?(\d+\.?\d*|\.\d+)[dD][-+]?\d+');
    fields(isFortran) = regexprep (fields(isFortran), '[dD]', 'e');
  end
  if any (text == ',')
    fields = withPoints (fields, where, byComma);
  end
end

function fields = withPoints (fields, where, byComma)
  tail = '([eE][-+]?\d+)?( ?(%|abs|[^\s\d.,;:+-][^\s.,;]*))?';    % a unit
  isDecimal = isLike (fields, ['[-+]?\d*(\.\d{3})*,\d*', tail]) & ...
              ~strcmp (fields, ',');
  isThousand = isLike (fields, ['[-+]?[1-9]\d{0,2}(,\d{3})+\.\d*', tail]);
  % these may be either
  isCommaThree = isLike (fields, ['[-+]?[1-9]\d{0,2},\d{3}', tail]);
  isPointThree = isLike (fields, ['[-+]?[1-9]\d{0,2}(\.\d{3})+', tail]);
  isPoint = isLike (fields, ['[-+]?\d*\.\d*', tail]) & ~isPointThree;
  hasComma = any (isDecimal & ~isCommaThree);
  hasPoint = any (isThousand) || (any (isPoint | byComma) && ~hasComma);
  if any (isPointThree) && any (isDecimal) && ~any (isThousand)
    refuse (fields, where, find (isPointThree, 1), '.,');
  elseif any (isCommaThree) && hasPoint && (hasComma || ~any (isThousand))
    refuse (fields, where, find (isCommaThree, 1), ',.');
  elseif hasPoint
    isThousand = isThousand | isCommaThree;
  end
  isDecimal = isDecimal & ~isThousand;
  fields(isThousand) = strrep (fields(isThousand), ',', '');
  fields(isDecimal) = strrep (strrep (fields(isDecimal), '.', ''), ',', '.');
end

% MARKS: the one that is unclear, and the other one.
function refuse (fields, where, k, marks)
  error ('DEcalioc:readCsvTable:unclearPoint', ...
         ['readCsvTable: numbers of the table must be clear, got %s in %s: a ' ...
          'thousand or a decimal number, beside the others there? Write %s ' ...
          'or %s.'], fields{k}, where (k), strrep (fields{k}, marks(1), ''), ...
         strrep (fields{k}, marks(1), marks(2)));
end

function yes = isLike (fields, pattern)
  yes = ~cellfun ('isempty', regexp (fields, ['^', pattern, '$'], 'once'));
end

%!function out = clear1 (varargin)
%!  out = clearNumbers (varargin', @(k) sprintf ('field %d', k), false)';
%!endfunction
%!assert (clear1 ('0,5', '-1,5e-3', '1.234,5', '1,234', 'a, b', '2,5 %'), ...
%!        {'0.5', '-1.5e-3', '1234.5', '1.234', 'a, b', '2.5 %'})
%!assert (clear1 ('12,5 deg', '3,1mm', '0,5 kg/m3', '1,5 a b'), ...
%!        {'12.5 deg', '3.1mm', '0.5 kg/m3', '1,5 a b'})
%!assert (clear1 ('1,234.5', '1,234', '12.5'), {'1234.5', '1234', '12.5'})
%!assert (clear1 ('1 234,5', '12''345.5', '''0.5''', '1.5D-3', 'a''b 1'), ...
%!        {'1234.5', '12345.5', '0.5', '1.5e-3', 'a''b 1'})
%!assert (clear1 ([char([226, 136, 146]), '3'], '0,5', '0.5'), {'-3', '0.5', '0.5'})
%!assert (clear1 ('1,234', '2'), {'1.234', '2'})
%!error <Write 1002 or 1,002> clear1 ('26,5', '1.002')
%!error <Write 1781 or 1.781> clear1 ('0.5', '1,781')
%!error id=DEcalioc:readCsvTable:unclearPoint clear1 ('0,5', '1,234', '1,234.5')
%!error <got 1,234 in f> clearNumbers ({'1,234'}, @(k) 'f', true)
%!assert (clearNumbers ({'1,234'; '0,5'}, @(k) 'f', true), {'1.234'; '0.5'})

% SPDX-License-Identifier: GPL-3.0-only
