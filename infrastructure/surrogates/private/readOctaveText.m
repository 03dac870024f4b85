% READOCTAVETEXT  Reads a struct of texts and matrices that save -text wrote.
%
% CALL: S = readOctaveText (FILE)
%
%   FILE  path (text) of a file with one scalar struct
%   S     scalar struct of its texts, real scalars and real matrices; a field of
%         another kind, or one that is torn, is left out
%
% Unlike Octave's load this evaluates nothing.

function s = readOctaveText (file)
  s = struct ();
  text = asUtf8 (fileread (file));
  [first, last, parts] = regexp (text, ...
                                 '^# name: (\w+)\r?\n# type: ([\w ]+)\r?\n', ...
                                 'start', 'end', 'tokens', 'lineanchors');
  first(end + 1) = numel (text) + 1;
  for k = 1:numel (parts)
    value = valueOf (text(last(k) + 1:first(k + 1) - 1), parts{k}{2});
    if iscell (value)
      s.(parts{k}{1}) = value{1};
    end
  end
end

% A cell with the value; [] where it is none of these kinds, or torn.
function value = valueOf (body, kind)
  value = [];
  switch strrep (kind, 'null_', '')
    case {'string', 'sq_string'}
      [parts, stop] = regexp (body, '^# elements: 1\n# length: (\d+)\n', ...
                              'tokens', 'end', 'once');
      if strncmp (body, '# elements: 0', 13)
        value = {''};
      elseif ~isempty (parts)
        n = str2double (parts{1});
        value = wholeText (body(stop + 1:end), n);
      end
    case 'scalar'
      number = sscanf (body, '%f');
      if isscalar (number)
        value = {number};
      end
    case 'matrix'
      [parts, stop] = regexp (body, '^# rows: (\d+)\n# columns: (\d+)\n', ...
                              'tokens', 'end', 'once');
      if ~isempty (parts)
        value = wholeMatrix (body(stop + 1:end), str2double (parts));
      end
  end
end

function value = wholeText (body, n)
  value = [];
  if n <= numel (body)
    value = {body(1:n)};
  end
end

function value = wholeMatrix (body, sizes)
  value = [];
  numbers = sscanf (body, '%f');
  if numel (numbers) == prod (sizes)
    value = {reshape(numbers, sizes(2), sizes(1))'};
  end
end

%!test
%! kept = struct ('name', 'a b', 'none', '', 'X', [1/3, NaN; -Inf, 4], ...
%!                'z', zeros (0, 3), 'p', pi, 'v', [1; 2]);
%! file = tempname ();
%! save ('-text', file, 'kept');
%! s = readOctaveText (file);
%! assert (s, kept);
%! % a byte that is no UTF-8
%! text = fileread (file);
%! text(strfind (text, 'a b') + 1) = char (200);
%! writeAtomic (file, text);
%! assert (readOctaveText (file).X, kept.X);
%! % what is no text, scalar or matrix is not there
%! other = struct ('f', @sin, 'c', {{1}}, 'x', 1);
%! save ('-text', file, 'other');
%! assert (readOctaveText (file).x, 1);
%! assert (! isfield (readOctaveText (file), 'f'));

% SPDX-License-Identifier: GPL-3.0-only
