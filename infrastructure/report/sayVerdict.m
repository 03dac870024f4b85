% SAYVERDICT  Says what a result may be used for, and what to do.
%
% CALL: sayVerdict (V, SAY)
%
%   V    see decideCase
%   SAY  function handle that takes one line of text

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

%!test
%! [~, text] = situationPage ('met, one parameter open');
%! assert (! isempty (strfind (text, '  use it for: flows like those that')));
%! assert (! isempty (strfind (text, '  not for: flows in which b matters')));
%! assert (! isempty (strfind (text, '  targets met: 3 of 3')), text);
%! assert (! isempty (strfind (text, '  what to do: Use the set')), text);
