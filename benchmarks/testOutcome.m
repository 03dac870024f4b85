% TESTOUTCOME  What a verdict says of the one true cause.
%
% CALL: [CELLS, ISOPEN] = testOutcome (WHICH, TRUTH)
%
%   WHICH   struct verdict, guard, effects, of a diagnosis or its gap.json
%   TRUTH   name of the cause
%   CELLS   1 x 2 cell, 0 or 1: named rightly; named wrongly. A verdict that it
%           is this one or something that looks like it counts as a name
%   ISOPEN  logical: which kind of cause it is stays open (a group, undecided)
%
% See also: wholeRuns

function [cells, isOpen] = testOutcome (which, truth)
  isAlike = strcmp (which.guard, 'look-alike');
  isOpen = any (strcmp (which.verdict, {'group', 'undecided'})) && ~isAlike;
  isName = strcmp (which.verdict, 'named') || ...
           (strcmp (which.verdict, 'group') && isAlike);
  isTrue = isequal (cellstr (which.effects), {truth});
  cells = {double(isName && isTrue), double(isName && ~isTrue)};
end

%!test
%! which = @(verdict, guard, varargin) ...
%!   struct ('verdict', verdict, 'guard', guard, 'effects', {varargin});
%! [cells, isOpen] = testOutcome (which ('named', '', 'a'), 'a');
%! assert ({cells{:}, isOpen}, {1, 0, false});
%! [cells, isOpen] = testOutcome (which ('group', 'look-alike', 'b'), 'a');
%! assert ({cells{:}, isOpen}, {0, 1, false});
%! [cells, isOpen] = testOutcome (which ('group', 'group', 'a', 'b'), 'a');
%! assert ({cells{:}, isOpen}, {0, 0, true});

% SPDX-License-Identifier: GPL-3.0-only
