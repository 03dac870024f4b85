% CHECKPLAINTEXT  Checks that a file is text as bash and LIGGGHTS read it.
%
% CALL: P = checkPlainText (FILE, FIELD)
%
%   FILE   path (text); one that is not there has no fault
%   FIELD  its name for the user, see checkFault
%   P      1 x n faults, see checkFault
%
% What Octave reads may be in any encoding (readText). Other programs take a
% mark at the begin for a word, and UTF-16 or CR line ends for one long line.

function p = checkPlainText (file, field)
  p = checkFault ();
  fid = fopen (file, 'r');
  if fid < 0
    return
  end
  text = fread (fid, [1, Inf], 'uint8=>char');
  fclose (fid);
  is = @(bytes) strncmp (text, char (bytes), numel (bytes));
  table = {is([239, 187, 191]), 'a mark of UTF-8 (BOM) at its begin'; ...
           is([255, 254]) || is([254, 255]), 'UTF-16'; ...
           any(text == "\r") && ~any(text == "\n"), ...
           'line ends of an old Macintosh (CR)'};
  k = find ([table{:, 1}], 1);
  if ~isempty (k)
    p = checkFault ('badEncoding', field, 'plain text', table{k, 2}, ...
                    ['Save it as UTF-8 without a mark (BOM), with lines ' ...
                     'ended by a line feed.']);
  end
end

%!test
%! file = tempname ();
%! for text = {"a\nb\n", false; "a\r\nb\r\n", false; "a\rb\r", true; ...
%!             ["# H", char(246), "he\n"], false; ...
%!             [char([239, 187, 191]), "a\n"], true; ...
%!             char([255, 254, 97, 0, 10, 0]), true}'
%!   writeAtomic (file, text{1});
%!   p = checkPlainText (file, 'DEMmodels/M/data.head');
%!   assert (! isempty (p), text{2});
%! end
%! assert (p.id, 'DEcalioc:checkCase:badEncoding');
%!assert (isempty (checkPlainText ('/no/such/file', 'x')))

% SPDX-License-Identifier: GPL-3.0-only
