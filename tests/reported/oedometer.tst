% Issue 47, 5: an oedometer is loaded and unloaded, and both were one curve.

%!shared folder, measured
%! folder = reportedCase ('oedometer');
%! measured = fullfile (folder, 'measured.csv');
%!test
%! % in measured.csv; the places of the way back are no repeated trials
%! [status, out] = startCommand (folder, 'check');
%! assert (status != 0);
%! assert (! isempty (strfind (out, 'line 5, at: expected the places of p')));
%! text = fileread (measured);
%! same = strrep (strrep (text, '0.85,6.4', '0.75,4.4'), '0.65,2.5', '0.5,0.4');
%! writeAtomic (measured, same);
%! [status, out] = startCommand (folder, 'check');
%! assert (! isempty (strfind (out, 'line 5, at: expected the places of p')));
%!test
%! % in the curve of a run: the trial says so
%! there = strsplit (strtrim (fileread (measured)), "\n")(1:5);
%! writeAtomic (measured, sprintf ("%s\n", there{:}));
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status, 2);
%! assert (! isempty (strfind (out, ['the curve p turns back at 1: return ' ...
%!                                   'loading and unloading as two'])), out);
%!test
%! % cut where it turns, as docs/inputs.md says
%! text = strrep (fileread (measured), ',p,', ',loading,');
%! writeAtomic (measured, [text, "oedo,unloading,0.85,6.4,kPa,5%\n", ...
%!                         "oedo,unloading,0.65,2.5,kPa,5%\n"]);
%! funs = fullfile (folder, 'DEMmodels', 'oedo', 'OctaveFuns', 'getResults.m');
%! block = ["  record = load (file);\n  [~, top] = max (record(:, 1));\n", ...
%!          "  res.loading = record(1:top, :);\n  res.unloading = record(top:end, :);\n"];
%! body = strrep (fileread (funs), 'res.p = [NaN, NaN];', 'res = struct ();');
%! writeAtomic (funs, strrep (body, 'res.p = load (file);', block));
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status == 0, out);
%! assert (! isempty (regexp (out, 'unloading@0.65\s+\S+, measured 2.5')), out);

% SPDX-License-Identifier: GPL-3.0-only
