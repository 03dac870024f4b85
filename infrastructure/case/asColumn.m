% ASCOLUMN  Numbers given per model as one column, model by model.
%
% CALL: C = asColumn (VALUES)
%
%   VALUES  cell of M vectors (rows or columns), or one vector, as
%           optim.targetVal and optim.tolRes
%   C       n x 1

function c = asColumn (values)
  if iscell (values)
    values = cellfun (@(v) v(:), values(:), 'UniformOutput', false);
    values = vertcat (values{:});
  end
  c = values(:);
end

%!assert (asColumn ({[1, 2], [3; 4], 5}), (1:5)')
%!assert (asColumn ([1, 2]), [1; 2])
