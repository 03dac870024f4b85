% NEXTTEXT  A further measurement as an instruction, with what it would tell.
%
% CALL: [TEXT, WITHOUT] = nextText (TEST)
%
%   TEST  scalar struct test, trials, gain, between (cell of names), as in
%         gap.json
%   TEXT  'measure SlotBin with a right slot of 45 mm, 3 trials: to decide
%         between cohesion and liquidBridge with 0.90 bit'
%   WITHOUT  the same without how much

function [text, without] = nextText (test)
  without = test.test;
  if jsonAt (test, {'trials'}) > 1
    without = sprintf ('%s, %d trials', without, test.trials);
  end
  text = sprintf ('%s: %.2f bit', without, test.gain);
  between = jsonAt (test, {'between'});
  if numel (between) == 2
    between = plainName (strrep (between, 'no gap', 'no cause'));   % or no change
    without = sprintf ('%s: to decide between %s and %s', without, between{:});
    text = sprintf ('%s with %.2f bit', without, test.gain);
  end
end

%!test
%! test = struct ('test', 'measure A', 'gain', 0.9, 'trials', 3, ...
%!                'between', {{'a', 'no gap'}});
%! assert (nextText (test), ['measure A, 3 trials: to decide between a ', ...
%!                           'and no cause with 0.90 bit']);
%! test.between = {'wallAdhesion + shape', 'cohesion'};
%! assert (! isempty (strfind (nextText (test), 'between wall adhesion + shape and cohesion')));
%! assert (nextText (struct ('test', 'measure A once more', 'gain', 0.04)), ...
%!         'measure A once more: 0.04 bit');

% SPDX-License-Identifier: GPL-3.0-only
