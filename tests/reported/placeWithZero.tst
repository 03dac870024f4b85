% Places of a curve in runs.csv as a spreadsheet writes them, 0.0020 for 0.002:
% its columns were missing.

%!test
%! folder = reportedCase ('placeWithZero');
%! file = fullfile (folder, 'runs.csv');
%! text = fileread (file);
%! forms = {text, strrep(text, 'p@0.0020', 'P@2.0E-3'), ...
%!          strrep(strrep (strrep (text, ',', ';'), '.', ','), 'p@', 'p @ ')};
%! for form = forms
%!   writeAtomic (file, form{1});
%!   [status, out] = startCommand (folder, 'check');
%!   assert (status == 0 && ! isempty (strfind (out, '10 sets taken in')), out);
%! end

% SPDX-License-Identifier: GPL-3.0-only
