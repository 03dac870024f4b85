% 60 rows of another script (discharge 6 % longer, tolerance 5 %) beside runs of today's.
% Once the rows outvoted them: "CALIBRATED, more than 99 %" beside an own run that missed.

%!test
%! folder = reportedCase ('importedTableOutvotes');
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, out);
%! % the two are kept apart, and this is said before the verdict
%! at = strfind (out, 'The 60 rows of runs.csv are not used: for tDischarge');
%! verdict = strfind (out, 'CALIBRATED: ');
%! assert (! isempty (at) && at(end) < verdict(end), out);
%! assert (! isempty (strfind (out, "\n  runs that count: ")), out);
%! c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%! assert (! isempty (c.sources.misled));
%! % what is confirmed holds: of the mean of its runs, and of the script itself
%! mu = c.params.friction_1_1;
%! ro = c.params.rollingFriction_1_1;
%! truth = [0.94 * (0.36 + 0.5 * mu + 0.1 * ro), 26 * (1 - exp(-ro / 0.1)) + 10 * (mu - 0.4)];
%! assert (abs ([c.targets.result] - [c.targets.target]) <= [c.targets.allowed]);
%! assert (abs (truth - [c.targets.target]) <= [c.targets.allowed]);

% SPDX-License-Identifier: GPL-3.0-only
