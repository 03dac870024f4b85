% JUDGEDHOW  By what it was judged how far a cause closes the gap.
%
% CALL: TEXT = judgedHow (FAR)
%
%   FAR   howFar of gap.json
%   TEXT  'by DEM runs', or that only the fitted surfaces say it

function text = judgedHow (far)
  byDem = isequal (jsonAt (far, {'verifiedByDEM'}), true);
  text = sentence (merge (byDem, 'closed.byDEM', 'closed.onSurrogates'));
end

%!assert (judgedHow (struct ('verifiedByDEM', true)), sentence ('closed.byDEM'))
%!assert (judgedHow ([]), sentence ('closed.onSurrogates'))

% SPDX-License-Identifier: GPL-3.0-only
