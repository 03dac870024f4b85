% WAITUNTIL  Waits until something holds; a test that waits for ever says nothing.
%
% CALL: waitUntil (HOLDS)
%       waitUntil (HOLDS, SECONDS)
%
%   HOLDS    handle () -> logical
%   SECONDS  after which it is an error (default 120, for a machine that others
%            use, too)
%
% Errors: DEcalioc:waitUntil:never

function waitUntil (holds, seconds)
  if nargin < 2
    seconds = 120;
  end
  last = time () + seconds;
  while ~holds ()
    if time () > last
      error ('DEcalioc:waitUntil:never', ...
             'waitUntil: %s must hold within %g s, and did not.', ...
             func2str (holds), seconds);
    end
    pause (0.05);
  end
end

%!test
%! last = time () + 0.1;
%! waitUntil (@() time () > last);
%! assert (time () > last);
%!error id=DEcalioc:waitUntil:never waitUntil (@() false, 0.1)

% SPDX-License-Identifier: GPL-3.0-only
