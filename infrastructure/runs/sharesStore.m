% SHARESSTORE  Tells whether the runs of a case lie in a store for several cases.
%
% CALL: YES = sharesStore (CASE)
%
%   CASE  see newCase
%   YES   logical; false where Input.store is the case folder: all runs are its own
%
% See also: runPlace, isOwnRun

function yes = sharesStore (Case)
  yes = ~strcmp (Case.store, givenField (Case, 'folder', ''));
end

%!assert (sharesStore (struct ('store', '/s', 'folder', '/c')))
%!assert (~sharesStore (struct ('store', '/c', 'folder', '/c')))

% SPDX-License-Identifier: GPL-3.0-only
