% FOLLOWEDREADINGS  The readings of a change that decide: the model can follow them.
%
% CALL: [LIST, OTHERS] = followedReadings (GAP)
%
%   GAP           decoded gap/gap.json
%   LIST, OTHERS  1 x n cells of reference.targets, followed or not (setAside); empty for
%                 a gap without a reference

function [list, others] = followedReadings (gap)
  all_ = jsonList (gap, {'reference', 'targets'});
  isFollowed = cellfun (@(T) givenField (T, 'followed', true), all_);
  list = all_(isFollowed);
  others = all_(~isFollowed);
end

%!test
%! gap.reference.targets = struct ('name', {'a', 'b', 'c'}, 'followed', {true, false, true});
%! [list, others] = followedReadings (gap);
%! assert (cellfun (@(T) T.name, list), 'ac');
%! assert (others{1}.name, 'b');
%!assert (followedReadings (struct ('reference', [])), cell (1, 0))

% SPDX-License-Identifier: GPL-3.0-only
