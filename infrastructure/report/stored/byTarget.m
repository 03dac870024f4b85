% BYTARGET  Values of targets by the names of model and target.
%
% CALL: S = byTarget (TARGETS, VALUES)
%
%   TARGETS  1 x T struct array with modelName and name, see newCase
%   VALUES   T cells, one for each
%   S        struct: S.(model).(target), names as the user has them

function s = byTarget (targets, values)
  s = struct ();
  for t = 1:numel (targets)
    s.(targets(t).modelName).(targets(t).name) = values{t};
  end
end

%!test
%! T = struct ('modelName', {'Heap', 'Drum', 'Heap'}, 'name', {'slope', 'slope', 'p@0.002'});
%! s = byTarget (T, {1, 2, 3});
%! assert (jsonencode (s), ...
%!         '{"Heap":{"slope":1,"p@0.002":3},"Drum":{"slope":2}}');

% SPDX-License-Identifier: GPL-3.0-only
