% Effects x benches: neutral is the null model to the last digit; at full
% strength every effect runs; a bench says beforehand what it cannot express.
% With DECALIOC_SOAK=1 every effect is set to neutral alone on every bench, and
% the measured table of signs is held against the library.

%!shared benches, root
%! root = fileparts (fileparts (which ('benchTrial')));
%! benches = {'Collapse', 'Drum', 'Heap', 'Shear', 'SlotBin'};

%!function effects = ofDem ()
%!  effects = resolveEffects (listEffects ());
%!  effects = effects(~[effects.laboratory]);
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

%!test % only the slot bins have slots
%! e = resolveEffects ({'opening'});
%! can = cellfun (@(b) effectsOfModel (fullfile (root, 'DEMmodels', b), e), ...
%!                benches);
%! assert (can, strcmp (benches, 'SlotBin'));

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
%! % each effect at full strength runs on the small shear cell or slot bin, and
%! % the grains end elsewhere
%! null.Shear = benchTrial ('Shear', benchScale ('Shear'));
%! null.SlotBin = benchTrial ('SlotBin', benchScale ('SlotBin'));
%! for e = ofDem ()
%!   bench = 'Shear';
%!   if ~effectsOfModel (fullfile (root, 'DEMmodels', bench), e)
%!     bench = 'SlotBin';
%!   end
%!   set = withEffect (benchScale (bench), e, e.limits(2, :));
%!   [text, fault] = benchTrial (bench, set);
%!   assert (fault, '');
%!   assert (~isequal (text, null.(bench)), e.name);
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
