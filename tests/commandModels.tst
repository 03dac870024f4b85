% Models that decalioc new makes, on real LIGGGHTS: from the template, with the
% candidate effects at neutral, and from a script that takes -var; doctor.

%!shared root, base
%! root = fileparts (fileparts (which ('startProgram')));
%! base = fullfile (tempname (), 'it''s here');
%! mkdir (base);

%!function yes = says (text, part)
%!  yes = ~isempty (strfind (text, part));
%!endfunction

% --- a model of one's own, made, tried, and neutral
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! [status, out] = startCommand (base, 'new --model Pile');
%! assert (status, 0);
%! folder = fullfile (base, 'Pile');
%! model = fullfile (folder, 'DEMmodels', 'Pile');
%! head = fullfile (model, 'data.head');
%! writeAtomic (head, [fileread(head), "variable filledSolid equal 4e-6\n"]);
%! [status, out] = startCommand (base, 'check --try Pile');
%! assert (status == 0, out);
%! assert (says (out, 'trial     Pile: ok'));
%! assert (says (out, ' runs, 3 new, 1 taken from the store'));
%! picture = fileread (fullfile (folder, 'optim', 'Pile', '0001', ...
%!                               'measured.svg'));
%! assert (says (picture, '<circle') && says (picture, '<polyline'));
%! % the time that was asked for is run to the step: up to the next look at
%! % the overlap, two settings would be one run
%! log = fileread (fullfile (folder, 'optim', 'Pile', '0001', 'log.liggghts'));
%! took = str2double (regexp (log, ['secondsRun equal [\d.]+\+(\d+)\*' ...
%!                            '([\d.e-]+)'], 'tokens', 'once'));
%! assert (prod (took), 0.06 / 0.12, 1.01 * took(2));
%! % effects at neutral: bit by bit the grains of a law without effects
%! small = struct ('filledSolid', 4e-6, 'restTime', 0.12, 'liftHeight', 0.012);
%! [plain, fault] = benchTrial (model, small, fullfile (root, 'tests', ...
%!                                                      'plainLaw'));
%! assert (fault, '');
%! effects = resolveEffects (listEffects ());
%! effects = effects(effectsOfModel (model, effects) & ~[effects.laboratory]);
%! assert (numel (effects) >= 14);
%! for e = effects(~strcmp ({effects.name}, 'fill'))
%!   for k = 1:numel (e.variables)
%!     small.(e.variables{k}) = e.neutral(k);
%!   end
%! end
%! [neutral, fault] = benchTrial (model, small);
%! assert (fault, '');
%! assert (isequal (neutral, plain));
%! % and one that is switched on is not
%! small.tiltAngle = 2;
%! assert (~isequal (benchTrial (model, small), plain));

% --- a script of one's own that takes -var NAME VALUE
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! text = fileread (fullfile (root, 'examples', 'ownScript', 'in.slump'));
%! text = strrep (strrep (text, 'particles_in_region 400', ...
%!                        'particles_in_region 60'), '0.5/', '0.02/');
%! writeAtomic (fullfile (base, 'in.mine'), text);
%! words = ['new --model Mine --script in.mine --vary mu=0.2:0.8 ', ...
%!          '--vary roll=0.02:0.3 --set radius=1.4e-3 --seed packing ', ...
%!          '--target run-out=0.0195 --target height=0.0057 ', ...
%!          '--output output_centre ''my own'''];
%! [status, out] = startCommand (base, words);
%! assert (status == 0, out);
%! assert (~says (out, 'NOTE'), out);
%! [status, out] = startCommand (base, 'check --try ''my own''');
%! assert (status == 0, out);
%! assert (says (out, 'trial     Mine: ok'));
%! % what the script got is what the run was to have
%! run = fullfile (base, 'my own', 'optim', 'Mine', '0001');
%! d = headDefaults (fullfile (run, 'data.head'));
%! record = readRecord (fullfile (run, 'record.json'));
%! log = fileread (fullfile (run, 'log.liggghts'));
%! assert (d.mu, record.params(1));
%! got = regexp (log, 'coefficientFriction peratomtypepair 1[ &\n]+(\S+)', ...
%!               'tokens');
%! assert (str2double (got{end}{1}), d.mu, 1e-12);
%! got = regexp (log, 'insert/pack seed (\d+)', 'tokens');
%! assert (str2double (got{end}{1}), record.seed);
%! got = regexp (log, 'radius constant ([\d.e-]+)', 'tokens');
%! assert (str2double (got{end}{1}), 1.4e-3);
%! assert (load (fullfile (run, 'output_centre')), record.results, 1e-12);

% --- doctor
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! [status, out] = startCommand (base, 'doctor');
%! assert (status == 0, out);
%! assert (says (out, 'trial run  ok'));

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % a heap of a filling 0.1 m high in a tube of 36 mm
%! [text, fault] = benchTrial ('Heap', struct ('radiusP', 3.5e-3, 'heapSolid', 6e-5, ...
%!                                             'tubeRadius', 0.018, 'plateRadius', 0.036, ...
%!                                             'restTime', 0.06, 'liftHeight', 0.006));
%! assert (fault, '');
%! count = @(name) str2double (regexp (text, ['(?<=', name, ',)\d+'], 'match', 'once'));
%! assert (count ('spheresStart') > 250 && count ('spheresSettled') == count ('spheresStart'));

%!test
%! % the same LIGGGHTS in a window of any width
%! words = 'cd "%s"; COLUMNS=%d bash -c ". tools/liggghts/settings.sh; buildFolder sources"';
%! [~, narrow] = system (sprintf (words, root, 60));
%! [~, wide] = system (sprintf (words, root, 150));
%! assert (! isempty (narrow) && strcmp (narrow, wide), wide);

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (base), 's');

% SPDX-License-Identifier: GPL-3.0-only
