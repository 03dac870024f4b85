% ASUTF8  Turns the bytes of a text into UTF-8, in whatever encoding they are.
%
% CALL: TEXT = asUtf8 (BYTES)
%
%   BYTES  1 x n char, as read: UTF-8 or UTF-16 with its mark (BOM), or without
%          one UTF-8, or what is none, which is read as Windows-1252 (a table
%          saved by Excel as plain CSV)
%   TEXT   1 x m char in UTF-8, without the mark
%
% regexp, strsplit and regexprep throw at a text that is no UTF-8.
% Source: RFC 3629, section 4 (which bytes may follow each other).

function text = asUtf8 (bytes)
  text = bytes;
  if ~any (bytes > 127)
    return
  end
  marks = {char([239, 187, 191]), 'UTF-8'; char([255, 254]), 'UTF-16LE'; ...
           char([254, 255]), 'UTF-16BE'};
  k = find (cellfun (@(m) strncmp (bytes, m, numel (m)), marks(:, 1)), 1);
  if ~isempty (k)
    text = bytes(numel (marks{k, 1}) + 1:end);
  end
  if ~isempty (k) && k > 1
    text = converted (text(1:end - mod (end, 2)), marks{k, 2});
  elseif ~isUtf8 (text)
    text = converted (text, 'windows-1252');
  end
end

function text = converted (bytes, encoding)
  text = reshape (native2unicode (uint8 (bytes), encoding), 1, []);
end

% A byte that leads announces how many follow; no longer form than needed, no
% half of a pair of UTF-16, nothing beyond U+10FFFF.
function yes = isUtf8 (text)
  b = [double(text), 0, 0, 0];
  announced = (b >= 194 & b < 245) + (b >= 224 & b < 245) + ...
              (b >= 240 & b < 245);
  isTail = b >= 128 & b < 192;
  isDue = [0, announced(1:end - 1) > 0] | [0, 0, announced(1:end - 2) > 1] | ...
          [0, 0, 0, announced(1:end - 3) > 2];
  next = [b(2:end), 0];
  isBad = b == 192 | b == 193 | b > 244 | b == 224 & next < 160 | ...
          b == 237 & next > 159 | b == 240 & next < 144 | ...
          b == 244 & next > 143;
  yes = isequal (isTail, isDue) && ~any (isBad);
end

%!assert (asUtf8 ('plain'), 'plain')
%!assert (asUtf8 (''), '')
%!test
%! % a degree sign and an umlaut in each encoding
%! degree = char ([97, 194, 176, 195, 188]);
%! for bytes = {[97, 176, 252], [97, 194, 176, 195, 188], ...
%!              [239, 187, 191, 97, 194, 176, 195, 188], ...
%!              [255, 254, 97, 0, 176, 0, 252, 0], ...
%!              [254, 255, 0, 97, 0, 176, 0, 252], ...
%!              [254, 255, 0, 97, 0, 176, 0, 252, 0]}
%!   assert (asUtf8 (char (bytes{1})), degree);
%! end
%!test
%! % every text that comes out is one that regexp takes, and what regexp took
%! % stays: all pairs, and random bytes (with DECALIOC_SOAK=1 five times as many)
%! rand ('twister', 5);
%! n = 400 * (1 + 4 * strcmp (getenv ('DECALIOC_SOAK'), '1'));
%! texts = num2cell (char (randi ([0, 255], n, 4)), 2)';
%! for lead = 128:255
%!   texts{end + 1} = char ([65, lead, 128, 128, 65]);
%!   texts{end + 1} = char ([65, lead, 191, 191, 191]);
%!   texts{end + 1} = char ([lead, 143, 143, 143, 66]);
%! end
%! for text = texts
%!   out = asUtf8 (text{1});
%!   regexp (out, 'x');
%!   isTaken = true;
%!   try
%!     regexp (text{1}, 'x');
%!   catch
%!     isTaken = false;
%!   end
%!   isMarked = any (strncmp (text{1}, {char([239, 187, 191])}, 3));
%!   assert (isTaken <= (isMarked || strcmp (out, text{1})), true);
%! end

% SPDX-License-Identifier: GPL-3.0-only
