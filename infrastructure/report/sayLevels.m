% SAYLEVELS  Says what each level has told and cost.
%
% CALL: sayLevels (C, CASE, SAY)
%
%   C     see newCalibration; nothing is said where it has no levels
%   CASE  see newCase
%   SAY   function handle that takes one line of text
%
% See also: describeLevels, levelLine, reportCalibration

function sayLevels (c, Case, say)
  if isempty (c.levels)
    return
  end
  say (sprintf ('  %-28s %5s %12s   %s', 'level', 'runs', 'core-seconds', ...
                'what it does to the responses at the set'));
  names = {Case.coarse.variable};
  for k = 1:numel (c.levels)
    own = c.levels(k);
    text = namedValues (names, own.value);
    what = 'counts';
    if k < numel (c.levels)
      what = levelLine (own, Case.targets);
    end
    say (sprintf ('  %-28s %5d %12.3g   %s', text, own.runs, own.seconds, ...
                  what));
  end
  say ('');
end
