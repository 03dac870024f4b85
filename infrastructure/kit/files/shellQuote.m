% SHELLQUOTE  Wraps a text so that a shell takes it as one plain word.
%
% CALL: WORD = shellQuote (TEXT)
%
%   TEXT  1 x n char, any characters but NUL
%   WORD  TEXT in single quotes, each single quote inside written as '\''
%
% Errors: DEcalioc:shellQuote:badType

function word = shellQuote (text)
  if ~ischar (text) || any (text == 0)
    error ('DEcalioc:shellQuote:badType', ...
           'shellQuote: TEXT must be char without NUL, got %s.', class (text));
  end
  word = ['''', strrep(text, '''', '''\'''''), ''''];
end

%!assert (shellQuote ('a b'), '''a b''')
%!assert (size (shellQuote ('')), [1, 2])
%!test
%! nasty = ['it''s $(touch x) `y` "z" ; \ ', "\t", ' *'];
%! [~, out] = system (['printf %s ', shellQuote(nasty)]);
%! assert (out, nasty);
%!error id=DEcalioc:shellQuote:badType shellQuote (1)

% SPDX-License-Identifier: GPL-3.0-only
