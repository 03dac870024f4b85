% WEIGHSEACH  Whether each trial counts by an uncertainty of its own.
%
% CALL: YES = weighsEach (TRIALS)
%
%   TRIALS  1 x n struct of readMeasured, lines of one quantity in one state
%   YES     logical: all have an sd, these differ, and no two are of one block. What is
%           alike is an error that trials have in common, such as that of a balance

function yes = weighsEach (trials)
  own = [trials.sd];
  yes = numel (trials) > 1 && all (own > 0) && any (own ~= own(1)) && ...
        ~any (isinf ([trials.repeats]));
  if yes && isfield (trials, 'block')
    names = strcat ({trials.session}, {'|'}, {trials.block});
    names = names(~cellfun (@isempty, {trials.block}));
    yes = numel (unique (names)) == numel (names);
  end
end

%!test
%! trials = struct ('sd', {0.1, 0.2}, 'repeats', NaN, 'session', 'mon', 'block', {'x', 'y'});
%! assert (weighsEach (trials));
%! assert (~weighsEach (trials(1)));
%! [trials.block] = deal ('x');
%! assert (~weighsEach (trials));
%! [trials.block] = deal ('');
%! assert (weighsEach (trials));
%! [trials.sd] = deal (0.1);
%! assert (~weighsEach (trials));
%! [trials.sd] = deal (0.1, 0);
%! assert (~weighsEach (trials));

% SPDX-License-Identifier: GPL-3.0-only
