% The example of another DEM code, YADE: its runs are runs like any other, one
% that was cut short is none, and the benches in YADE know their effects.

%!shared root
%! root = fileparts (fileparts (which ('startProgram')));

%!function Case = smallCase (root, change)
%!  % a case in a new folder with a column of 190 grains and two targets;
%!  % change (folder of the model) spoils it
%!  folder = tempname ();
%!  model = fullfile (folder, 'DEMmodels', 'YadeCollapse');
%!  mkdir (fileparts (model));
%!  system (sprintf ('cp -rL %s %s', shellQuote (fullfile (root, ...
%!          'examples', 'yade', 'DEMmodels', 'YadeCollapse')), ...
%!          shellQuote (model)));
%!  change (model);
%!  raw = struct ('folder', folder, 'root', root, 'effects', []);
%!  raw.Input = struct ('model', {{'YadeCollapse'}}, 'cpu', 1, ...
%!                      'maxCPU', 2, 'numOfSam', 8);
%!  raw.optim = struct ('targetVal', {{[600, 0.05, 0.01, 0.01, 10, 0.1]}}, ...
%!                      'tolRes', 0.1, 'WRL', 0);
%!  raw.modelVars = struct ('columnSolid', 0.01);
%!  raw.assign = {'densityP', 'coefFrictionPP'};
%!  raw.paramLims = [900, 0.2; 1400, 0.7];
%!  Case = newCase (raw);
%!endfunction

%!function back = nameOfYade ()
%!  % the checks look for a program of that name; these tests do not start it
%!  before = getenv ('PATH');
%!  back = onCleanup (@() setenv ('PATH', before));
%!  if isempty (file_in_path (before, 'yade'))
%!    folder = tempname ();
%!    mkdir (folder);
%!    writeAtomic (fullfile (folder, 'yade'), "exit 1\n");
%!    setenv ('PATH', [before, ':', folder]);
%!  end
%!endfunction

%!function replaceIn (file, old, new)
%!  text = fileread (file);
%!  assert (~isempty (strfind (text, old)));
%!  writeAtomic (file, strrep (text, old, new));
%!endfunction

%!function record = recordOf (root, change)
%!  Case = smallCase (root, change);
%!  [~, record] = evaluateDEM ([1200, 0.5], Case);
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (Case.folder, 's');
%!endfunction

%!test % the form of the example has no mistake but that YADE may be missing
%! back = nameOfYade ();
%! Case = smallCase (root, @(model) []);
%! names = {resultInfo(Case.models(1).folder).name};
%! assert (numel (Case.targets), numel (names));
%! effects = resolveEffects ({'tilt', 'sizeSpread', 'moistDensity', ...
%!                            'meanSize', 'wallFriction', 'rolling', 'drag', ...
%!                            'restitution', 'stiffness', 'fill'});
%! assert (effectsOfModel (Case.models(1).folder, effects));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');

%!test % the bench in YADE is read with the functions of that in LIGGGHTS
%! own = fullfile (root, 'examples', 'yade', 'DEMmodels', 'YadeCollapse');
%! for file = {'results.csv', 'OctaveFuns/measureBench.m'}
%!   assert (fileread (fullfile (own, file{1})), ...
%!           fileread (fullfile (root, 'DEMmodels', 'Collapse', file{1})));
%! end

%!test % a folder of old simulations becomes a table: one that is whole, one not
%! back = nameOfYade ();
%! old = tempname ();
%! head = fileread (fullfile (root, 'examples', 'yade', 'DEMmodels', ...
%!                            'YadeCollapse', 'data.head'));
%! for name = {'a', 'b'}
%!   mkdir (fullfile (old, name{1}));
%!   writeAtomic (fullfile (old, name{1}, 'data.head'), ...
%!                sprintf ('%svariable runSeed equal %d\n', head, ...
%!                         10000 + double (name{1})));
%! end
%! sample = fullfile (root, 'DEMmodels', 'Collapse', 'sample');
%! copyfile (fullfile (sample, '*'), fullfile (old, 'a'));
%! file = fullfile (old, 'runs.csv');
%! here = cd (fullfile (root, 'examples', 'yade'));
%! clear loadInput
%! n = tableOfFolder (old, file);
%! Case = loadCase (root, pwd ());
%! cd (here);
%! clear loadInput
%! data = importRuns (file, withEffects (Case));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (old, 's');
%! assert (n, 2);
%! assert (data.X, repmat ([1200, 0.5, 0.05], 2, 1));
%! words = regexp (fileread (fullfile (sample, 'expected.csv')), ',(\S+)', ...
%!                 'tokens');
%! assert (data.Z, [str2double([words{:}]); NaN(1, 6)], -1e-6);

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'yade'))
%! % two densities, one packing: the bulk density follows, the rest does not.
%! % The same seed gives the same digits; another seed other ones
%! Case = smallCase (root, @(model) []);
%! [Z, record] = evaluateDEM ([1000, 0.5; 1200, 0.5], Case);
%! assert ({record.status}, {'ok', 'ok'});
%! assert (Z(2, 1) / Z(1, 1), 1.2, 0.02);
%! assert (Z(:, 1) ./ [1000; 1200], [0.55; 0.55], 0.08);
%! assert (Z(:, 2:4) > 0 & Z(:, 2:4) < 0.06);
%! assert (Z(:, 3) > Z(:, 4));
%! assert (Z(:, 6) > 0.03 & Z(:, 6) < 0.3);
%! checks = readChecks (record(1).folder);
%! assert (checks.sane);
%! assert (checks.spheresEnd, 191);
%! again = tempname ();
%! mkdir (again);
%! system (sprintf (['cd %s && cp data.head grains.py in.*.py runscript %s ' ...
%!                   '&& cd %s && bash runscript > out 2> err < /dev/null'], ...
%!                  shellQuote (record(1).folder), again, again));
%! same = @(name) strcmp (fileread (fullfile (again, name)), ...
%!                        fileread (fullfile (record(1).folder, name)));
%! assert (same ('deposit.dump'));
%! assert (same ('output_checks.csv'));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%! rmdir (again, 's');

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'yade'))
%! % a script that ends early and well, one that stumbles, one that is killed
%! script = 'in.YadeCollapse.py';
%! early = @(m) replaceIn (fullfile (m, script), ...
%!                         'watch = grains.Watch(v)', 'raise SystemExit(0)');
%! wrong = @(m) replaceIn (fullfile (m, script), ...
%!                         'watch = grains.Watch(v)', 'noSuchName()');
%! killed = @(m) writeAtomic (fullfile (m, 'runscript'), ...
%!   "yade -x -n -j1 in.YadeCollapse.py & sleep 0.5; kill -9 $!; wait $!\n");
%! r = recordOf (root, early);
%! assert (r.status, 'failed');
%! assert (~isempty (strfind (r.message, 'did not run to the last line')));
%! r = recordOf (root, wrong);
%! assert (r.status, 'failed');
%! assert (~isempty (strfind (r.message, 'noSuchName')));
%! r = recordOf (root, killed);
%! assert ({r.status, r.cause}, {'failed', 'killed'});

%!testif ; system ('[ "$DECALIOC_SOAK" = 1 ] && command -v yade >&2') == 0
%! % the README, followed literally in a copy of the clone
%! place = tempname ();
%! system (sprintf (['mkdir %s && cd %s && git ls-files -z | ' ...
%!                   'xargs -0 cp -P --parents -t %s'], place, ...
%!                  shellQuote (root), place));
%! text = fileread (fullfile (root, 'examples', 'yade', 'README.md'));
%! blocks = regexp (text, '```\n(.*?)```', 'tokens');
%! assert (numel (blocks), 2);
%! for block = [blocks{:}]
%!   lines = regexprep (block{1}, '^apt-get.*$', '', 'lineanchors', ...
%!                      'dotexceptnewline');
%!   script = sprintf ('set -e; PATH=%s/bin:$PATH; cd %s\n%s', place, place, ...
%!                     lines);
%!   [status, out] = system (['bash -c ', shellQuote(script), ...
%!                            ' 2>&1 < /dev/null']);
%!   assert (status == 0, [lines, out]);
%! end
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (place, 's');

% SPDX-License-Identifier: GPL-3.0-only
