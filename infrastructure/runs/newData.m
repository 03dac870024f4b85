% NEWDATA  Empty table of finished evaluations.
%
% CALL: DATA = newData (D, T)
% CALL: DATA = newData (D, T, V)
%
% D, T, V  number of design variables, of responses, of effect variables (0)
% DATA     struct: X 0 x d, E 0 x v, Z 0 x T, replicate 0 x 1, stage {} 0 x 1

function data = newData (d, T, v)
  if nargin < 3
    v = 0;
  end
  data = struct ('X', zeros (0, d), 'E', zeros (0, v), ...
                 'Z', zeros (0, T), 'replicate', zeros (0, 1));
  data.stage = cell (0, 1);
end

%!test
%! data = newData (3, 2);
%! assert ({size(data.X), size(data.Z), size(data.E)}, ...
%!         {[0, 3], [0, 2], [0, 0]});
