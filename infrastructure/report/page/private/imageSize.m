% IMAGESIZE  Width and height of a JPEG or PNG picture, from its bytes.
%
% CALL: PIXELS = imageSize (BYTES)
%
%   BYTES  1 x n uint8, the file
%   PIXELS   1 x 2, width and height in pixels; NaN where it is another file

function pixels = imageSize (bytes)
  pixels = [NaN, NaN];
  b = double (bytes(:)');
  if numel (b) > 24 && isequal (char (b(2:4)), 'PNG')
    pixels = [b(17:20); b(21:24)] * 256.^(3:-1:0)';
    pixels = pixels';
    return
  elseif numel (b) < 4 || ~isequal (b(1:2), [255, 216])
    return
  end
  at = 3;                               % segments: marker, length, content
  while at + 8 <= numel (b) && b(at) == 255
    isFrame = b(at + 1) >= 192 && b(at + 1) <= 207 && ~any (b(at + 1) == [196, 200, 204]);
    if isFrame
      pixels = [256 * b(at + 7) + b(at + 8), 256 * b(at + 5) + b(at + 6)];
      return
    end
    at = at + 2 + 256 * b(at + 2) + b(at + 3);
  end
end

%!test
%! png = uint8 ([137, double('PNG'), 13, 10, 26, 10, 0, 0, 0, 13, double('IHDR'), 0, 0, 1, 44, ...
%!               0, 0, 0, 200, 8]);
%! assert (imageSize (png), [300, 200]);
%! jpeg = uint8 ([255, 216, 255, 224, 0, 4, 1, 2, 255, 192, 0, 17, 8, 0, 200, 1, 44, 3]);
%! assert (imageSize (jpeg), [300, 200]);
%! assert (imageSize (uint8 ('abc')), [NaN, NaN]);

% SPDX-License-Identifier: GPL-3.0-only
