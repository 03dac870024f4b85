% No floor, and thermo_modify lost ignore: every grain left the box, and the trial was ok.

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! folder = reportedCase ('allGrainsLost');
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, 'thermo_modify lost ignore: grains that leave')), out);
%! assert (! isempty (strfind (out, '180 of 180 grains were lost')), out);

%!test
%! % a new case says it of the script, before anything is run
%! folder = reportedCase ('allGrainsLost');
%! script = fullfile (folder, 'DEMmodels', 'Pile', 'in.nofloor');
%! place = tempname ();
%! [status, out] = startCommand (folder, sprintf (['new --model Pile --script %s ' ...
%!   '--vary fGG=0.2:0.8 --seed seedPack --target far=0.02 --output result.txt %s'], ...
%!   script, place));
%! assert (status == 0 && ! isempty (strfind (out, 'lost ignore')), out);

% SPDX-License-Identifier: GPL-3.0-only
