% BADINPUTS  All bad loadInputs of the tests, one row each.
%
% CALL: ROWS = badInputs ()
%
%   ROWS  n x 4 cell: reason (last part of the identifier that must come
%         first), path and value (see spoil), a text that the message must
%         name ('': the path)
%
% Each row spoils one thing of goodInput. Those of loadEffects: badEffects.
%
% See also: badFields, badTargets, badVariables, badEffects, badFiles

function rows = badInputs ()
  rows = [badFields(); badTargets(); badVariables(); badFiles()];
end

%!assert (rows (badInputs ()) >= 150)
%!assert (columns (badInputs ()), 4)

% SPDX-License-Identifier: GPL-3.0-only
