% CHECKSHOW  Describes any value in a few words, for a message.
%
% CALL: TEXT = checkShow (VALUE)
%
%   VALUE  anything
%   TEXT   1 x n char, at most about 80 characters, printable
%
% Never throws.

function text = checkShow (value)
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
    text = sprintf ('a %s %s', sizeOf (value), kindOf (value));
  end
end

function text = printable (text)
  text = text(:)';
  if numel (text) > 60
    text = [text(1:57), '...'];
  end
  text(text < 32 | text == 127) = '?';
end

function text = kindOf (value)
  if isnumeric (value)
    text = 'matrix';
    if ~isa (value, 'double')
      text = ['matrix of class ', class(value)];
    elseif iscomplex (value)
      text = 'complex matrix';
    end
  elseif isstruct (value)
    text = 'struct';
  elseif iscell (value)
    text = 'cell';
  else
    text = class (value);
  end
end

function text = sizeOf (value)
  text = sprintf ('%d x ', size (value));
  text = text(1:end - 3);
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
    words = arrayfun (@(z) sprintf ('%.6g%+.6gi', real (z), imag (z)), ...
                      value, 'UniformOutput', false);
  else
    words = arrayfun (@(z) sprintf ('%.6g', z), value, ...
                      'UniformOutput', false);
  end
  text = strjoin (words, ', ');
  if numel (words) > 1
    text = ['[', text, ']'];
  end
  text = [kind, text];
end

%!assert (checkShow (3.5), '3.5')
%!assert (checkShow ([1; NaN]), '[1, NaN]')
%!assert (checkShow (int8 (3)), 'int8 3')
%!assert (checkShow (2 + 1i), '2+1i')
%!assert (checkShow ("a\nb"), '''a?b''')
%!assert (checkShow (''), '''''')
%!assert (checkShow ({1, 2}), 'a 1 x 2 cell')
%!assert (checkShow (struct ()), 'a 1 x 1 struct')
%!assert (checkShow ([]), 'an empty matrix')
%!assert (checkShow (@sin), 'the function handle sin')
%!assert (checkShow (zeros (2, 3, 4)), 'a 2 x 3 x 4 matrix')
%!assert (checkShow (containers.Map ()), 'an object of class containers.Map')
%!assert (numel (checkShow (repmat ('x', 1, 1000))) < 80)
