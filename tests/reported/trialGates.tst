% Issue 72, 3: a trial whose results no heap can have was "ok" without a word. Three
% slips, and the rig as it is, on LIGGGHTS.

%!function out = tried (density, radius)
%!  folder = tempname ();
%!  [status, out] = startCommand (tempdir (), ['new --bench Heap ', folder]);
%!  assert (status == 0, out);
%!  put = @(name, from, to) writeAtomic (fullfile (folder, name), ...
%!    strrep (fileread (fullfile (folder, name)), from, to));
%!  put ('measured.csv', 'Heap,slope,,', 'Heap,slope,31.3,');
%!  put ('measured.csv', 'Heap,massOnPlate,,,kg', 'Heap,massOnPlate,14.1,,g');
%!  put ('loadInput.m', 'densityP = 1200', ['densityP = ', density]);
%!  put ('loadInput.m', 'radiusP = 0.002', ['radiusP = ', radius]);
%!  [status, out] = startCommand (folder, 'check --try');
%!  assert (status == 0 && ! isempty (strfind (out, 'Heap: ok')), out);
%!endfunction
%!function says (out, parts)
%!  for part = parts
%!    assert (! isempty (regexp (out, ['WARNING   Heap: ', part{1}], 'once')), out);
%!  end
%!endfunction
%!test
%! % the rig of the toolbox
%! out = tried ('1200', '0.002');
%! assert (isempty (strfind (out, 'WARNING')), out);
%!test
%! % as reported: radius for diameter, bulk for grain density
%! out = tried ('690', '0.004');
%! says (out, {'slope: 8\d.* is the radius of a grain its diameter', ...
%!             'massOnPlate: measured 0.0141 kg, more than .* that of the bulk', ...
%!             'the heap is higher than a cone'});
%!test
%! % the bulk density alone
%! says (tried ('690', '0.002'), {'massOnPlate: .* that of the bulk'});

% SPDX-License-Identifier: GPL-3.0-only
