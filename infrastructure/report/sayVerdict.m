% SAYVERDICT  Says what a result may be used for, and what to do.
%
% CALL: sayVerdict (V, SAY)
%
%   V    see decideCase
%   SAY  function handle that takes one line of text
%
% See also: reportCalibration, sayDiagnosis, sayStatus

function sayVerdict (v, say)
  for k = 1:numel (v.usableFor)
    say (['  use it for: ', v.usableFor{k}]);
  end
  for k = 1:numel (v.notFor)
    say (['  not for: ', v.notFor{k}]);
  end
  for k = 1:numel (v.numbers)
    say (sprintf ('  %s: %s', v.numbers(k).label, v.numbers(k).text));
  end
  say (['  what to do: ', v.action]);
end
