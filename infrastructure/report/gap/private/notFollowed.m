% NOTFOLLOWED  Says which readings the model cannot follow, and what changed there.
%
% CALL: TEXTS = notFollowed (GAP)
%
%   GAP    decoded gap/gap.json
%   TEXTS  1 x n cell: a sentence each, or one for all where these are more than three;
%          the points of a curve are one name

function texts = notFollowed (gap)
  [~, others] = followedReadings (gap);
  texts = cell (1, 0);
  if numel (others) > 3
    names = strtok (cellfun (@(T) T.name, others, 'UniformOutput', false), '@');
    texts = {sentence('cause.notFollowedAny', unique (names, 'stable'))};
  elseif ~isempty (others)
    texts = eachOf (@(T) oneText (T), others);
  end
end

function text = oneText (T)
  factor = jsonNumber (T, {'shown', 'factor'}, 1);
  unit = regexprep (char (jsonAt (T, {'shown', 'unit'})), '^-$', '');
  in = @(x) strtrim (sprintf ('%.3g %s', x / factor, unit));
  text = sentence ('cause.notFollowed', ...
                   struct ('name', T.name, 'simulated', in (T.simulated), ...
                           'reference', in (T.reference), ...
                           'change', in (T.measured - T.reference)));
end

%!test
%! T = struct ('name', {'tilt', 'x@1', 'x@2', 'x@3'}, 'simulated', 0.6, 'reference', 0.2, ...
%!             'measured', 0.5, 'followed', false, 'shown', struct ('unit', 'g', 'factor', 0.1));
%! gap.reference.targets = T;
%! text = notFollowed (gap){1};
%! assert (~isempty (strfind (text, 'tilt, x:')), text);
%! gap.reference.targets = T(1);
%! text = notFollowed (gap){1};
%! assert (~isempty (strfind (text, '6 g where 2 g was measured. It has changed by 3 g')), ...
%!         text);
%! gap.reference.targets(1).followed = true;
%! assert (notFollowed (gap), cell (1, 0));

% SPDX-License-Identifier: GPL-3.0-only
