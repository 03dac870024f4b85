% NAMEDVALUES  Text 'a = 1, b = 2' of names and their values.
%
% CALL: TEXT = namedValues (NAMES, VALUES)
% CALL: TEXT = namedValues (NAMES, VALUES, FORMAT)
%
%   NAMES   cellstr of n names
%   VALUES  n numbers
%   FORMAT  of a number, as sprintf takes it ('%g')

function text = namedValues (names, values, format)
  if nargin < 3
    format = '%g';
  end
  words = [names(:)'; num2cell(values(:)')];
  parts = sprintf (['%s = ', format, ', '], words{:});
  text = parts(1:end - 2);
end

%!assert (namedValues ({'a'}, 0.5), 'a = 0.5')
%!assert (namedValues ({'a'; 'b'}, [1, 1 / 3], '%.2g'), 'a = 1, b = 0.33')

% SPDX-License-Identifier: GPL-3.0-only
