% A script with a derived pair, "variable mu21 equal ${mu12}", as many users of
% LIGGGHTS write it: with 17 digits LIGGGHTS took the two for different numbers,
% and each run stopped ("must be symmetric").

%!testif ; system ('command -v liggghts > /dev/null') == 0
%! root = fileparts (which ('DEcalioc'));
%! folder = reportedCase ('digits');
%! [status, out] = startCommand (folder, ['new --script in.sym --model ', ...
%!                                        'Sym --vary mu12=0.2:0.8 ', ...
%!                                        '--target mu=0.4 case']);
%! assert (status == 0, out);
%! [status, out] = startCommand (folder, 'check --try case');
%! assert (status == 0, out);
%! raw = goodInput (fullfile (folder, 'case'));
%! raw.root = root;
%! raw.Input = struct ('model', {{'Sym'}}, 'cpu', 1, 'maxCPU', 1, ...
%!                     'numOfSam', 8);
%! raw.optim = struct ('targetVal', {{0.4}}, 'tolRes', {{0.02}});
%! raw.modelVars = struct ();
%! raw.assign = {'mu12'};
%! raw.paramLims = [0.2; 0.8];
%! Case = newCase (raw);
%! P = [1/3; 0.32999999999999996; 0.7];
%! [Z, records] = evaluateDEM (P, Case);
%! assert ({records.status}, {'ok', 'ok', 'ok'});
%! % what LIGGGHTS prints, what the record, the head and the table hold
%! assert (Z, toDigits (P));
%! for k = 1:3
%!   assert (records(k).params, toDigits (P(k)));
%!   head = headDefaults (fullfile (records(k).folder, 'data.head'));
%!   assert (head.mu12, toDigits (P(k)));
%!   table = csvread (fullfile (records(k).folder, 'params.csv'));
%!   assert (table, toDigits (P(k)));
%!   texts = fileread (fullfile (records(k).folder, 'params.csv'));
%!   assert (isempty (regexp (texts, '\d{16}', 'once')));
%! end
%! file = fullfile (folder, 'runs.csv');
%! exportRuns (file, Case, gatherRuns (Case));
%! assert (isempty (regexp (fileread (file), '\d{16}', 'once')));

%!test
%! % siblings: variables that are fixed, or follow of others (RLTS, SIMTS)
%! Case = newCase (standInCase (tempname ()));
%! Case.modelVars = struct ('x', 1/3, 'radiusP', 0.1 / 3, 'densityP', 2500, ...
%!                          'youngsModulusP', 5e6 / 3, ...
%!                          'poissonsRatioP', 0.3, ...
%!                          'percentRayleigh', 0.1 + 0.2);
%! folder = prepareRun (newJobs (Case, [1/3, 2/3], [], 1, 'plan')(1), Case);
%! head = fileread (fullfile (folder, 'data.head'));
%! assert (isempty (regexp (head, '[1-9]\d{15}', 'once')));
%! assert (~isempty (strfind (head, 'variable SIMTS equal ')));

% SPDX-License-Identifier: GPL-3.0-only
