% ISFINE  Which runs of a diagnosis are of the level that counts.
%
% CALL: [YES, HASLEVELS] = isFine (DATA)
%
%   DATA       see fitEmulator
%   YES        n x 1 logical; all where there are no levels
%   HASLEVELS  logical

function [yes, hasLevels] = isFine (data)
  yes = true (rows (data.X), 1);
  hasLevels = isfield (data, 'level');
  if hasLevels
    yes = ~any (data.level, 2);
  end
end

%!assert (isFine (struct ('X', [1; 2], 'level', [0, 0; 0, 1])), [true; false])
%!test
%! [yes, hasLevels] = isFine (struct ('X', [1; 2]));
%! assert ({yes, hasLevels}, {true(2, 1), false});

% SPDX-License-Identifier: GPL-3.0-only
