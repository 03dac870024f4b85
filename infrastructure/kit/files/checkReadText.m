% CHECKREADTEXT  Reads a file of the user as plain ASCII text.
%
% CALL: TEXT = checkReadText (FILE)
%
%   FILE  path (text)
%   TEXT  1 x n char, at most the first MB; '' where FILE cannot be read;
%         bytes beyond ASCII have become '?', so that a comment in another
%         encoding does no harm

function text = checkReadText (file)
  text = '';
  if ~isfile (file)
    return
  end
  fid = fopen (file, 'r');
  if fid < 0
    return
  end
  bytes = fread (fid, 2^20, 'uint8=>double')';
  fclose (fid);
  bytes(bytes > 127) = double ('?');
  text = char (bytes);
end

%!assert (checkReadText ('/nowhere/x'), '')
%!test
%! file = tempname ();
%! fid = fopen (file, 'w');
%! fwrite (fid, [97, 228, 10], 'uint8');
%! fclose (fid);
%! assert (checkReadText (file), "a?\n");

% SPDX-License-Identifier: GPL-3.0-only
