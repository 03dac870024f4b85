% Measured 0 without a tolerance, and optim.tolRes set: the advice was to set it.

%!test
%! folder = reportedCase ('toleranceOfZero');
%! [status, out] = startCommand (folder, 'check');
%! assert (status, 1);
%! assert (! isempty (strfind (out, '1 problem')), out);
%! assert (! isempty (strfind (out, 'measured.csv, line 2, tol')), out);
%! assert (! isempty (strfind (out, '0.1 abs')), out);
%! assert (isempty (strfind (out, 'Or set optim.tolRes')), out);
%! % what it says does help; a mean of trials that is 0 is one, too
%! file = fullfile (folder, 'measured.csv');
%! text = fileread (file);
%! writeAtomic (file, strrep (text, 'r4,0,,g/s,', 'r4,0,,g/s,0.1 abs'));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 0, out);
%! % nearly 0: nobody measures it as well as the share of it
%! writeAtomic (file, strrep (text, 'r4,0,,g/s,', 'r4,1e-9,0.1,g/s,5%'));
%! [status, out] = startCommand (folder, 'check');
%! assert (! isempty (regexp (out, 'WARNING   r4: its uncertainty .* its tolerance')), out);
%! writeAtomic (file, strrep (text, 'Orifice,r4,0,,g/s,', ...
%!                            "Orifice,r4,0.1,,g/s,\nOrifice,r4,-0.1,,g/s,"));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 1 && ! isempty (strfind (out, '0.1 abs')), out);

% SPDX-License-Identifier: GPL-3.0-only
