% CSVLINE  A line of a CSV file, which readCsvTable reads back.
%
% CALL: LINE = csvLine (FIELDS)
%
%   FIELDS  1 x n cell of texts (quoted where they must be) and numbers (as
%           exactNumber writes them; NaN: an empty field)

function line = csvLine (fields)
  for k = 1:numel (fields)
    field = fields{k};
    if isnumeric (field)
      fields{k} = '';
      if ~isnan (field)
        fields{k} = exactNumber (field);
      end
    elseif any (ismember (field, [',;"', "\n"]))
      fields{k} = ['"', strrep(field, '"', '""'), '"'];
    end
  end
  line = strjoin (fields, ',');
end

%!assert (csvLine ({'a', 'b;c', 0.1, NaN, 3, '"x", y', ''}), ...
%!        'a,"b;c",0.1,,3,"""x"", y",')

% SPDX-License-Identifier: GPL-3.0-only
