% SAYCHANGED  Says that the result in the files is of an earlier input.
%
% CALL: YES = sayChanged (CASE)
%
%   CASE  see newCase
%   YES   logical: the calibration is of an earlier input; of a diagnosis it is only
%         said

function yes = sayChanged (Case)
  [stored, verdict] = storedResult (Case);
  yes = ~isempty (stored.changed);
  if yes
    v = verdict ();
    printf ('NOTE  %s. %s\n', v.word, v.action);
  elseif ~isempty (stored.gapChanged)
    printf ('NOTE  %s\n', verdict ().gap);
  end
end

% SPDX-License-Identifier: GPL-3.0-only
