% Effects x benches: neutral is the null model to the last digit; at full
% strength every effect runs; a bench says beforehand what it cannot express.
% At full strength each effect moves a result by more than 3 noise standard
% deviations of one run. With DECALIOC_SOAK=1 every effect is also set to
% neutral alone on every bench.

%!shared benches, root
%! root = fileparts (fileparts (which ('benchTrial')));
%! benches = benchNames ();

%!function effects = ofDem ()
%!  effects = resolveEffects (listEffects ());
%!  effects = effects(~[effects.laboratory]);
%!endfunction

%!function v = benchScale (bench)
%!  % some ten to a hundred grains, too short for rest: only their places count
%!  root = fileparts (fileparts (which ('benchTrial')));
%!  v = headDefaults (fullfile (root, 'DEMmodels', bench, 'sample', ...
%!                              'small.head'));
%!endfunction

%!function v = withEffect (v, effect, values)
%!  for k = 1:numel (effect.variables)
%!    v.(effect.variables{k}) = values(k);
%!  end
%!endfunction

%!test % at least 14 effects of the DEM and 5 of the laboratory
%! effects = resolveEffects (listEffects ());
%! assert (sum (~[effects.laboratory]) >= 14);
%! assert (sum ([effects.laboratory]) >= 5);

%!test % each effect is expressed by one bench at least, neutral as declared
%! effects = resolveEffects (listEffects ());
%! seen = false (1, numel (effects));
%! for bench = benches
%!   folder = fullfile (root, 'DEMmodels', bench{1});
%!   can = effectsOfModel (folder, effects);
%!   seen = seen | can;
%!   head = checkHead (folder);
%!   for e = effects(can & ~[effects.laboratory])
%!     [~, at] = ismember (e.variables, {head.name});
%!     assert (str2double (strtok ({head(at).value}, ' ')), e.neutral);
%!   end
%! end
%! assert (seen);

%!test % slot bins have slots, a drum has none
%! e = resolveEffects ({'opening'});
%! can = @(b) effectsOfModel (fullfile (root, 'DEMmodels', b), e);
%! assert ([can('SlotBin'), can('Drum')], [true, false]);

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % all effects at neutral = a law that knows no effects, bit by bit
%! law = fullfile (root, 'tests', 'plainLaw');
%! for bench = benches
%!   small = benchScale (bench{1});
%!   [plain, fault] = benchTrial (bench{1}, small, law);
%!   assert (fault, '');
%!   effects = ofDem ();
%!   can = effectsOfModel (fullfile (root, 'DEMmodels', bench{1}), effects);
%!   set = small;
%!   for e = effects(can)
%!     set = withEffect (set, e, e.neutral);
%!   end
%!   if isfield (set, 'fillFactor')
%!     set = rmfield (set, 'fillFactor');
%!   end
%!   [neutral, fault] = benchTrial (bench{1}, set);
%!   assert (fault, '');
%!   assert (isequal (neutral, plain), bench{1});
%! end

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % each effect at both ends of its limits runs on the first small bench that
%! % expresses it, and the grains end elsewhere; the column stands on a slope
%! order = {'Shear', 'SlotBin', 'Heap', 'Collapse'};
%! for bench = order
%!   small.(bench{1}) = benchScale (bench{1});
%! end
%! small.Collapse.tiltCommanded = 10;
%! for bench = order
%!   null.(bench{1}) = benchTrial (bench{1}, small.(bench{1}));
%! end
%! can = @(b, e) effectsOfModel (fullfile (root, 'DEMmodels', b), e);
%! for e = ofDem ()
%!   bench = order{find (cellfun (@(b) can (b, e), order), 1)};
%!   for end_ = find (any (e.limits ~= e.neutral, 2))'
%!     set = withEffect (small.(bench), e, e.limits(end_, :));
%!     [text, fault] = benchTrial (bench, set);
%!     assert (fault, '');
%!     assert (~isequal (text, null.(bench)), e.name);
%!   end
%! end

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % plain effects combine; two cohesion models in one run are refused
%! set = benchScale ('SlotBin');
%! set.clumpAspect = 1.3;
%! set.sizeSpread = 0.1;
%! set.cohesionPP = 3e4;
%! set.tiltAngle = 1;
%! set.dragRate = 5;
%! [~, fault] = benchTrial ('SlotBin', set);
%! assert (fault, '');
%! for other = {'liquidContent', 'adhesionPP'}
%!   both = setfield (set, other{1}, 0.01);
%!   [~, fault] = benchTrial ('SlotBin', both);
%!   assert (~isempty (strfind (fault, 'has one of them at a time')));
%! end

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % single grains at the stop of a short floor are kept and do no harm; a front
%! % at the stop is no result. The front of 97 % is at 3.0 column lengths (sd
%! % 0.07), the farthest grain at 4 and more
%! stem = tempname ();
%! short = benchRun ([stem, 'a'], 'Collapse', struct ('floorLength', 3.7));
%! none = benchRun ([stem, 'b'], 'Collapse', struct ('floorLength', 2.5));
%! deposit = readDump ([stem, 'a/deposit.dump']){end};
%! system (['rm -r ', stem, 'a ', stem, 'b']);
%! assert (max (deposit(:, 1)) > 0.14);
%! assert (isfinite (short));
%! assert (isnan (none));

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % each effect at full strength, on the bench and the result where it was
%! % measured to be largest (effectsSeen.csv, of benchmarks/results): the
%! % result moves by more than 3 standard deviations of the noise, to the side
%! % that was measured. One run where that was 6 and more: a true 6 fails with a
%! % chance of 0.1 %. Else the mean of 4 runs, which fails where it contradicts
%! % 3 by two of its standard errors: a true 3 with a chance of 2.3 %, a true
%! % 3.5 of 0.1 %. No seed is one of the measured ones
%! [~, cells] = readCsvTable (fullfile (root, 'tests', 'effectsSeen.csv'));
%! assert (cells(:, 1)', sort ({ofDem().name}));
%! value = str2double (cells);
%! [bench, set, folder] = deal ({});
%! row = [];
%! for k = 1:rows (cells)
%!   one = withEffect (struct (), getEffect (cells{k, 1}), value(k, 2));
%!   if strcmp (cells{k, 1}, 'tiltShare')
%!     one.tiltCommanded = 10;
%!   end
%!   for seed = [10099, 10103, 10111, 10133](1:1 + 3 * (abs (value(k, 7)) < 6))
%!     one.runSeed = seed;
%!     bench{end + 1} = cells{k, 3};
%!     set{end + 1} = one;
%!     folder{end + 1} = tempname ();
%!     row(end + 1) = k;
%!   end
%! end
%! results = parcellfun (nproc (), @benchRun, folder, bench, set, ...
%!                       'UniformOutput', false, 'VerboseLevel', 0);
%! confirm_recursive_rmdir (false, 'local');
%! cellfun (@(f) rmdir (f, 's'), folder, 'UniformOutput', false);
%! for k = 1:rows (cells)
%!   info = resultInfo (fullfile (root, 'DEMmodels', cells{k, 3}));
%!   found = vertcat (results{row == k});
%!   change = mean (found(:, strcmp ({info.name}, cells{k, 4}))) - value(k, 5);
%!   change = change / value(k, 6);
%!   n = rows (found);
%!   least = 3 - 2 * (n > 1) / sqrt (n);
%!   assert (abs (change) > least, sprintf ('%s: %g', cells{k, 1}, change));
%!   assert (sign (change), sign (value(k, 7)));
%! end

%!testif ; strcmp (getenv ('DECALIOC_SOAK'), '1')
%! % one by one: each effect at neutral, on each bench
%! for bench = benches
%!   small = benchScale (bench{1});
%!   null = benchTrial (bench{1}, small);
%!   effects = ofDem ();
%!   can = effectsOfModel (fullfile (root, 'DEMmodels', bench{1}), effects);
%!   for e = effects(can)
%!     set = withEffect (small, e, e.neutral);
%!     assert (isequal (benchTrial (bench{1}, set), null), e.name);
%!   end
%! end

% SPDX-License-Identifier: GPL-3.0-only
