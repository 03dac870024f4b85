% SAYFIRST  Parts of a sentence with a text before them.
%
% CALL: PARTS = sayFirst (TEXT, PARTS)
%
%   TEXT   text without commands, files or fields; '': nothing
%   PARTS  1 x n struct array text, isCode, see sentence

function parts = sayFirst (text, parts)
  if ~isempty (text)
    parts = [struct('text', text, 'isCode', false), parts];
  end
end

%!test
%! parts = struct ('text', 'x.m', 'isCode', true);
%! assert ({sayFirst('see ', parts).text}, {'see ', 'x.m'});
%! assert (sayFirst ('', parts), parts);

% SPDX-License-Identifier: GPL-3.0-only
