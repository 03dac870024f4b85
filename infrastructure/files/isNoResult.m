% ISNORESULT  Words that stand for a result that is not there.
%
% CALL: YES = isNoResult (TEXTS)
%
%   TEXTS  cell of texts: fields of a table
%   YES    logical, of its size: -, --, n/a, NA, NaN, None, null, #N/A, ?

function yes = isNoResult (texts)
  words = {'-', '--', 'n/a', 'na', 'nan', 'none', 'null', '#n/a', '?'};
  % of no columns, too, the size is that of TEXTS
  yes = reshape (ismember (lower (texts(:)), words), size (texts));
end

%!assert (isNoResult ({'-', 'N/A', 'None', '', '0', '-1'}), ...
%!        logical ([1, 1, 1, 0, 0, 0]))
%!assert (size (isNoResult (cell (3, 0))), [3, 0])
