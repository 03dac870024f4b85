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
%! writeAtomic (file, strrep (text, 'Orifice,r4,0,,g/s,', ...
%!                            "Orifice,r4,0.1,,g/s,\nOrifice,r4,-0.1,,g/s,"));
%! [status, out] = startCommand (folder, 'check');
%! assert (status == 1 && ! isempty (strfind (out, '0.1 abs')), out);
