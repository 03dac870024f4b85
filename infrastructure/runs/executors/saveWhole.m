% SAVEWHOLE  Saves variables and reads them back: were they saved whole?
%
% CALL: ISWHOLE = saveWhole (FORMAT, FILE, KEPT)
%
%   FORMAT   '-text' or '-binary';  FILE  path (text)
%   KEPT     scalar struct, one field a variable
%   ISWHOLE  logical; false: FILE is torn or not there. save itself says
%            nothing of a full disk

function isWhole = saveWhole (format, file, kept)
  try
    save (format, file, '-struct', 'kept');
    isWhole = isequaln (load (file), kept);
  catch
    isWhole = false;
  end
end

%!test
%! file = tempname ();
%! kept = struct ('a', NaN, 'list', struct ('x', {1, 2}));
%! assert (saveWhole ('-binary', file, kept));
%! assert (isequaln (load (file), kept));
%! assert (saveWhole ('-text', file, kept));
%!assert (! saveWhole ('-text', [tempname(), '/a'], struct ('a', 1)))

% SPDX-License-Identifier: GPL-3.0-only
