% PLAINCASE  A case without candidate effects: of its runs only the levels vary.
%
% CALL: CASE = plainCase (CASE)
%
%   CASE  see newCase; comes back with no effects, and with effectVars (1 x v
%         cell) of the levels alone
%
% See also: withEffects

function Case = plainCase (Case)
  Case.effects = [];
  Case.effectVars = {Case.coarse.variable};
end

%!test
%! Case = struct ('effects', 1, 'effectVars', {{'s', 'e'}}, 'coarse', ...
%!                struct ('variable', {'s', 't'}));
%! assert (plainCase (Case).effectVars, {'s', 't'});
%! assert (isempty (plainCase (Case).effects));

% SPDX-License-Identifier: GPL-3.0-only
