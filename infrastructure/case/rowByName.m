% ROWBYNAME  Numbers given as one vector or by name, as one row.
%
% CALL: ROW = rowByName (VALUE, NAMES)
%
%   VALUE  1 x d or d x 1; or a struct whose fields are some of NAMES; or []
%   NAMES  1 x d cell
%   ROW    1 x d double, NaN where nothing is given

function row = rowByName (value, names)
  row = NaN (1, numel (names));
  if ~isstruct (value)
    row(1:numel (value)) = double (value(:)');
    return
  end
  for j = find (isfield (value, names))
    row(j) = double (value.(names{j}));
  end
end

%!assert (rowByName ([1; 2], {'a', 'b'}), [1, 2])
%!assert (rowByName (struct ('b', 3), {'a', 'b'}), [NaN, 3])
%!assert (rowByName ([], {'a', 'b'}), [NaN, NaN])
