% ISNORESULT  Words that stand for a result that is not there.
%
% CALL: YES = isNoResult (TEXTS)
%
%   TEXTS  cell of texts: fields of a table
%   YES    logical, of its size: -, --, n/a, NA, NaN, None, null, #N/A, ?

function yes = isNoResult (texts)
  yes = ismember (lower (texts), {'-', '--', 'n/a', 'na', 'nan', 'none', 'null', ...
                                  '#n/a', '?'});
end

%!assert (isNoResult ({'-', 'N/A', 'None', '', '0', '-1'}), ...
%!        logical ([1, 1, 1, 0, 0, 0]))
