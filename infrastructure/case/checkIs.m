% CHECKIS  Tells whether a value is of a kind that the input may hold.
%
% CALL: YES = checkIs (KIND, VALUE)
%
%   KIND   'number'   real finite scalar that is not sparse
%          'integer'  the same, and whole
%          'vector'   row or column of real numbers, not sparse, not empty
%          'text'     row of printable characters (UTF-8), not empty
%          'name'     text of letters, digits and _ that does not start with
%                     a digit, at most 63 long: a variable of LIGGGHTS
%          'struct'   one struct
%          'nothing'  empty: stands for a field that is not given
%   VALUE  anything
%   YES    true or false
%
% Never throws.
%
% See also: checkCase

function yes = checkIs (kind, value)
  switch kind
    case 'number'
      yes = isFinite (value);
    case 'integer'
      yes = isFinite (value) && value == fix (value);
    case 'vector'
      yes = isNumeric (value) && isvector (value) && ~isempty (value);
    case 'text'
      yes = isText (value);
    case 'name'
      yes = isText (value) && isName (value);
    case 'struct'
      yes = isstruct (value) && isscalar (value);
    otherwise
      yes = isNothing (value);
  end
end

function yes = isFinite (value)
  yes = isNumeric (value) && isscalar (value) && isfinite (value);
end

function yes = isNumeric (value)
  yes = isnumeric (value) && ~issparse (value) && isreal (value);
end

function yes = isText (value)
  yes = ischar (value) && isrow (value) && ~isempty (value) && ...
        all (value >= 32 & value ~= 127) && isUtf8 (value);
end

% Octave's own functions for paths throw at any other encoding.
function yes = isUtf8 (text)
  yes = true;
  if any (text > 127)
    try
      regexp (text, 'x', 'once');
    catch
      yes = false;
    end
  end
end

function yes = isName (text)
  isDigit = text >= '0' & text <= '9';
  isLetter = (text >= 'A' & text <= 'Z') | (text >= 'a' & text <= 'z');
  yes = numel (text) <= 63 && all (isDigit | isLetter | text == '_') && ...
        ~isDigit(1);
end

function yes = isNothing (value)
  yes = (isnumeric (value) || ischar (value) || iscell (value)) && ...
        isempty (value);
end

%!assert (checkIs ('number', 1.5))
%!assert (checkIs ('number', int32 (3)))
%!assert (! checkIs ('number', NaN))
%!assert (! checkIs ('number', 1i))
%!assert (! checkIs ('number', sparse (1)))
%!assert (! checkIs ('number', true))
%!assert (! checkIs ('number', {}))
%!assert (checkIs ('integer', 3))
%!assert (! checkIs ('integer', 3.5))
%!assert (checkIs ('vector', [1; NaN]))
%!assert (! checkIs ('vector', ones (2)))
%!assert (checkIs ('text', 'a b'))
%!assert (! checkIs ('text', "a\nb"))
%!assert (checkIs ('text', char ([195, 164])))
%!assert (! checkIs ('text', char (228)))
%!assert (checkIs ('name', 'coefFrictionPP'))
%!assert (! checkIs ('name', '1a'))
%!assert (! checkIs ('name', 'a b'))
%!assert (! checkIs ('name', char ([200, 255])))
%!assert (! checkIs ('struct', struct ('a', {1, 2})))
%!assert (checkIs ('nothing', []))
%!assert (! checkIs ('nothing', containers.Map ()))
