% PLAINNAME  The name of a cause as words: 'liquidBridge' is 'liquid bridge'.
%
% CALL: WORDS = plainName (NAMES)
%
%   NAMES  text, or cell of texts: names of effects
%   WORDS  the same shape, for sentences; in tables the name stands beside the
%          label

function words = plainName (names)
  if iscell (names)
    words = cellfun (@plainName, names, 'UniformOutput', false);
    return
  end
  words = regexprep (names, '(?<=[a-z0-9])([A-Z][a-z])', ' $1');
  if ~strcmp (words, names)
    words = lower (words);
  end
end

%!assert (plainName ({'liquidBridge', 'tilt', 'pH'}), ...
%!        {'liquid bridge', 'tilt', 'pH'})
%!assert (plainName ('meanSize'), 'mean size')
%!assert (plainName ({}), {})

% SPDX-License-Identifier: GPL-3.0-only
