% JSONAT  A value deep inside decoded JSON; empty where it is not there.
%
% CALL: VALUE = jsonAt (ROOT, PATH)
%
%   ROOT   what jsondecode returned
%   PATH   cell of field names and indices, from outside in; [] leads nowhere
%   VALUE  [] where a name or an index is missing (a result without that part, a null)
%
% Objects with equal fields are a struct array after decoding, others a cell:
% an index serves for both, and for arrays of numbers.

function value = jsonAt (root, path)
  value = root;
  for k = 1:numel (path)
    step = path{k};
    isName = ischar (step) && isscalar (value) && isfield (value, step);
    isIndex = isnumeric (step) && isscalar (step) && step <= numel (value);
    if isName
      value = value.(step);
    elseif isIndex && iscell (value)
      value = value{step};
    elseif isIndex
      value = value(step);
    else
      value = [];
      return
    end
  end
end

%!test
%! root = jsondecode ('{"a": [{"b": 1}, {"b": 2, "c": 3}], "d": [4, 5]}');
%! assert (jsonAt (root, {'a', 2, 'c'}), 3);
%! assert (jsonAt (root, {'d', 2}), 5);
%! assert (isempty (jsonAt (root, {'a', 1, 'c'})));
%! assert (isempty (jsonAt (root, {'d', 3})));
%! assert (isempty (jsonAt ([], {'a'})));

% SPDX-License-Identifier: GPL-3.0-only
