% DESCRIBEVALUE  Describes any value in a few words, for a message.
%
% CALL: TEXT = describeValue (VALUE)
%
%   VALUE  anything
%   TEXT   1 x n char, at most about 80 characters, printable
%
% Never throws.

function text = describeValue (value)
  try
    text = describe (value);
  catch
    text = sprintf ('something of class %s', class (value));
  end
end

function text = describe (value)
  if ischar (value) && (isrow (value) || isequal (size (value), [0, 0]))
    text = ['''', printable(value), ''''];
  elseif isa (value, 'function_handle')
    text = ['the function handle ', printable(func2str (value))];
  elseif isobject (value) || isjava (value)
    text = sprintf ('an object of class %s', class (value));
  elseif isempty (value)
    text = sprintf ('an empty %s', kindOf (value));
  elseif (isnumeric (value) || islogical (value)) && isvector (value) && ...
      numel (value) <= 6
    text = numbers (value);
  else
    text = sprintf ('%d x ', size (value));
    text = sprintf ('a %s %s', text(1:end - 3), kindOf (value));
  end
end

function text = printable (text)
  if numel (text) > 60
    text = [text(1:57), '...'];
  end
  text(text < 32 | text == 127) = '?';
end

function text = kindOf (value)
  text = class (value);
  if isa (value, 'double')
    text = [repmat('complex ', 1, iscomplex (value)), 'matrix'];
  elseif isnumeric (value)
    text = ['matrix of class ', text];
  end
end

function text = numbers (value)
  kind = '';
  if ~isa (value, 'double')
    kind = [class(value), ' '];
  elseif issparse (value)
    kind = 'sparse ';
  end
  value = double (full (value(:))).';
  if iscomplex (value)
    text = sprintf ('%.6g%+.6gi, ', [real(value); imag(value)]);
  else
    text = sprintf ('%.6g, ', value);
  end
  text = text(1:end - 2);
  if numel (value) > 1
    text = ['[', text, ']'];
  end
  text = [kind, text];
end

%!test
%! table = {3.5, '3.5'; [1; NaN], '[1, NaN]'; int8(3), 'int8 3'; ...
%!          2 + 1i, '2+1i'; "a\nb", '''a?b'''; '', ''''''; ...
%!          {1, 2}, 'a 1 x 2 cell'; struct(), 'a 1 x 1 struct'; ...
%!          [], 'an empty matrix'; @sin, 'the function handle sin'; ...
%!          zeros(2, 3, 4), 'a 2 x 3 x 4 matrix'; true, 'logical 1'; ...
%!          [1, 2i], '[1+0i, 0+2i]'; int8(ones (3)), ...
%!          'a 3 x 3 matrix of class int8'};
%! for row = table'
%!   assert (describeValue (row{1}), row{2});
%! end
%!assert (describeValue (containers.Map ()), 'an object of class containers.Map')
%!assert (numel (describeValue (repmat ('x', 1, 1000))) < 80)

% SPDX-License-Identifier: GPL-3.0-only
