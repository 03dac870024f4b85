% PLANTADVICE  What to look at in the plant, or on the rig, for a cause.
%
% CALL: TEXT = plantAdvice (NAMES)
%
%   NAMES  cellstr, effects
%   TEXT   sentences of plant.NAME in words.txt, each once; '' for others

function text = plantAdvice (names)
  texts = {};
  for name = names(:)'
    try
      texts{end + 1} = sentence (['plant.', name{1}]);
    catch
      % an effect of the user's own: nothing is known of it
    end
  end
  text = strjoin (unique (texts, 'stable'), ' ');
end

%!assert (plantAdvice ({'cohesion', 'myOwn', 'cohesion'}), sentence ('plant.cohesion'))
%!assert (plantAdvice ({}), '')

% SPDX-License-Identifier: GPL-3.0-only
