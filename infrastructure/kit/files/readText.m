% READTEXT  Reads a text file, whatever its encoding and line ends are.
%
% CALL: TEXT = readText (FILE)
%
%   FILE  path (text)
%   TEXT  1 x n char in UTF-8 (see asUtf8), lines ended by LF; '' where FILE
%         cannot be read

function text = readText (file)
  text = '';
  fid = fopen (file, 'r');
  if fid < 0
    return
  end
  bytes = fread (fid, [1, Inf], 'uint8=>char');
  fclose (fid);
  text = asUtf8 (bytes);
  if any (text == "\r")
    text = strrep (strrep (text, "\r\n", "\n"), "\r", "\n");
  end
end

%!assert (readText ('/no/such/file'), '')
%!assert (readText (tempdir ()), '')
%!test
%! file = tempname ();
%! for text = {"a\nb\n", "a\r\nb\r\n", "a\rb\r", ...
%!             char([255, 254, 97, 0, 13, 0, 10, 0, 98, 0, 10, 0])}
%!   writeAtomic (file, text{1});
%!   assert (readText (file), "a\nb\n");
%! end
%! writeAtomic (file, '');
%! assert (size (readText (file)), [1, 0]);

% SPDX-License-Identifier: GPL-3.0-only
