% TARGETAT  Place of a target in a list.
%
% CALL: K = targetAt (LIST, TARGET)
%
%   LIST    struct array with name, and model or modelName; [] for none
%   TARGET  scalar struct: name, model
%   K       its number in LIST; empty where it is not there

function k = targetAt (list, target)
  k = [];
  if isstruct (list)
    field = merge (isfield (list, 'modelName'), 'modelName', 'model');
    models = {list.(field)};
    k = find (strcmp ({list.name}, target.name) & ...
              strcmp (models, target.model), 1);
  end
end

%!assert (isempty (targetAt ([], struct ('name', 'h', 'model', 'B'))))
%!test
%! list = struct ('name', {'h', 'h'}, 'model', {'A', 'B'});
%! assert (targetAt (list, struct ('name', 'h', 'model', 'B')), 2);
%! list = struct ('name', {'h', 'h'}, 'modelName', {'B', 'A'});
%! assert (targetAt (list, struct ('name', 'h', 'model', 'A')), 2);

% SPDX-License-Identifier: GPL-3.0-only
