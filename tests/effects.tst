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

%!function v = withEffect (v, effect, values)
%!  for k = 1:numel (effect.variables)
%!    v.(effect.variables{k}) = values(k);
%!  end
%!endfunction

%!function table = signTable (root)
%!  table = csvWords (root, 'effectSigns.csv');
%!endfunction

%!function [m, sd] = noiseOf (root, bench, target)
%!  table = csvWords (root, 'benchNoise.csv');
%!  at = strcmp (table(:, 1), bench) & strcmp (table(:, 2), target);
%!  m = str2double (table{at, 4});
%!  sd = str2double (table{at, 5});
%!endfunction

%!function words = csvWords (root, name)
%!  [~, words] = readCsvTable (fullfile (root, 'benchmarks', 'results', name));
%!endfunction

%!test % at least 14 effects of the DEM and 5 of the laboratory
%! effects = resolveEffects (listEffects ());
%! assert (sum (~[effects.laboratory]) >= 14);
%! assert (sum ([effects.laboratory]) >= 5);

%!test % names in confusedWith are names of the library
%! names = listEffects ();
%! for e = resolveEffects (names)
%!   assert (ismember (e.confusedWith, names));
%! end

%!test % each effect is expressed by one bench at least, neutral as declared
%! effects = resolveEffects (listEffects ());
%! seen = false (1, numel (effects));
%! for bench = benches
%!   folder = fullfile (root, 'DEMmodels', bench{1});
%!   [can, reason] = effectsOfModel (folder, effects);
%!   assert (cellfun (@isempty, reason), can);
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
%! % each effect at both ends of its limits runs on the small shear cell or slot
%! % bin, and the grains end elsewhere
%! null.Shear = benchTrial ('Shear', benchScale ('Shear'));
%! null.SlotBin = benchTrial ('SlotBin', benchScale ('SlotBin'));
%! for e = ofDem ()
%!   bench = 'Shear';
%!   if ~effectsOfModel (fullfile (root, 'DEMmodels', bench), e)
%!     bench = 'SlotBin';
%!   end
%!   for end_ = find (any (e.limits ~= e.neutral, 2))'
%!     set = withEffect (benchScale (bench), e, e.limits(end_, :));
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
%! set.liquidContent = 0.01;
%! [~, fault] = benchTrial ('SlotBin', set);
%! assert (~isempty (strfind (fault, 'cohesion and liquidContent together')));

%!test % the measured table of signs holds every effect on every bench that can,
%! % and each moves something by more than 3 standard deviations
%! table = signTable (root);
%! z = abs (str2double (table(:, 7)));
%! effects = resolveEffects (listEffects ());
%! for bench = unique (table(:, 3))'   % a new bench is not measured yet
%!   folder = fullfile (root, 'DEMmodels', bench{1});
%!   for e = effects(effectsOfModel (folder, effects))
%!     at = strcmp (table(:, 1), e.name) & strcmp (table(:, 3), bench{1});
%!     has = sum (at) == numel (resultInfo (folder)) || ...
%!           strcmp (table(at, 8), 'failed');
%!     assert (has, [e.name, ' ', bench{1}]);
%!   end
%! end
%! for e = effects
%!   seen = strcmp (table(:, 1), e.name) & z > 3 & isfinite (z);
%!   assert (any (seen), e.name);
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
%! % each effect at full strength, on the bench where the table has it largest:
%! % the result moves by more than 3 standard deviations of the noise, to
%! % the side that the table says. One run where the table has 6 and more: a
%! % true 6 fails with a chance of 0.1 %. Else the mean of 4 runs, which fails
%! % where it contradicts 3 by two of its standard errors: a true 3 with a
%! % chance of 2.3 %, a true 3.5 of 0.1 %. No seed is one of the table's
%! table = signTable (root);
%! [bench, set, folder, best, effect] = deal ({});
%! for e = ofDem ()
%!   own = table(strcmp (table(:, 1), e.name), :);
%!   z = str2double (own(:, 7));
%!   z(~isfinite (z)) = 0;
%!   [~, k] = max (abs (z));
%!   one = withEffect (struct (), e, str2double (own{k, 2}));
%!   for seed = [10099, 10103, 10111, 10133](1:1 + 3 * (abs (z(k)) < 6))
%!     one.runSeed = seed;
%!     bench{end + 1} = own{k, 3};
%!     set{end + 1} = one;
%!     folder{end + 1} = tempname ();
%!     best{end + 1} = own(k, :);
%!     effect{end + 1} = e.name;
%!   end
%! end
%! results = parcellfun (nproc (), @benchRun, folder, bench, set, ...
%!                       'UniformOutput', false, 'VerboseLevel', 0);
%! confirm_recursive_rmdir (false, 'local');
%! cellfun (@(f) rmdir (f, 's'), folder, 'UniformOutput', false);
%! for name = unique (effect)
%!   at = find (strcmp (effect, name{1}));
%!   own = best{at(1)};
%!   info = resultInfo (fullfile (root, 'DEMmodels', own{3}));
%!   rows = vertcat (results{at});
%!   [mean0, sd] = noiseOf (root, own{3}, own{4});
%!   change = (mean (rows(:, strcmp ({info.name}, own{4}))) - mean0) / sd;
%!   least = 3 - 2 * (numel (at) > 1) / sqrt (numel (at));
%!   assert (abs (change) > least, sprintf ('%s: %g', name{1}, change));
%!   assert (sign (change), sign (str2double (own{7})));
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
