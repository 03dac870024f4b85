% CHECKFAULT  Puts one fault of the input into words.
%
% CALL: P = checkFault ()
%       P = checkFault (REASON, FIELD, EXPECTED, GOT, CURE)
%
%   REASON    last part of the identifier (text)
%   FIELD     what is wrong, as the user writes it, e.g. Input.cpu (text); a
%             path below DEMmodels/ names a file
%   EXPECTED  what should stand there (text)
%   GOT       what stands there (text, see describeValue), or the message of an error,
%             whose full stop is left out
%   CURE      what to do (text, a sentence)
%   P         struct array with the fields id and message: 1 x 1, or 1 x 0
%             when called without arguments

function p = checkFault (reason, field, expected, got, cure)
  if nargin == 0
    p = struct ('id', cell (1, 0), 'message', cell (1, 0));
    return
  end
  got = got(1:end - (~isempty (got) && got(end) == '.'));
  message = sprintf ('%s%s: expected %s, got %s. %s', field, ...
                     fileOf (field), expected, got, cure);
  p = struct ('id', ['DEcalioc:checkCase:', reason], 'message', message);
end

function text = fileOf (field)
  if strncmp (field, 'effects', 7)
    text = ' in loadEffects.m';
  elseif any (field == '/') || strncmp (field, 'measured.csv', 12)
    text = '';
  else
    text = ' in loadInput.m';
  end
end

%!assert (size (checkFault ()), [1, 0])
%!test
%! p = checkFault ('badCpu', 'Input.cpu', 'an integer', '0', 'Set 1.');
%! assert (p.id, 'DEcalioc:checkCase:badCpu');
%! assert (p.message, ...
%!         'Input.cpu in loadInput.m: expected an integer, got 0. Set 1.');
%!assert (checkFault ('a', 'x.csv', 'b', 'c. Save it.', 'Or not.').message, ...
%!        'x.csv in loadInput.m: expected b, got c. Save it. Or not.')
%!assert (checkFault ('a', 'effects(1).name', 'b', 'c', 'd').message, ...
%!        'effects(1).name in loadEffects.m: expected b, got c. d')
%!assert (checkFault ('a', 'x', 'b', char ([255, 46]), 'd').message(end - 3:end), ...
%!        [char(255), '. d'])                       % no text in UTF-8

% SPDX-License-Identifier: GPL-3.0-only
