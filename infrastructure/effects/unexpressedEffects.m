% UNEXPRESSEDEFFECTS  Which candidate effects which benches cannot express.
%
% CALL: TEXTS = unexpressedEffects (CASE)
%
% CASE   see newCase; effects as of resolveEffects
% TEXTS  1 x n cell, one line a bench that misses an effect; to be said before
%        any run. Effects that no bench can express come first.
%
% See also: effectsOfModel
function texts = unexpressedEffects (Case)
  texts = {};
  models = Case.models(isfolder ({Case.models.folder}));
  if isempty (Case.effects) || isempty (models)
    return
  end
  names = {Case.effects.name};
  can = false (numel (models), numel (names));
  for k = 1:numel (models)
    can(k, :) = effectsOfModel (models(k).folder, Case.effects);
  end
  nowhere = ~any (can, 1);
  if any (nowhere)
    texts{1} = sprintf ('no bench can express %s', ...
                        strjoin (names(nowhere), ', '));
  end
  for k = find (any (~can & ~nowhere, 2)).'
    texts{end + 1} = sprintf ('%s cannot express %s', models(k).name, ...
                              strjoin (names(~can(k, :) & ~nowhere), ', '));
  end
end

%!test % heap and slot bins: the heap has no slot, neither has a drum's speed
%! root = fileparts (fileparts (fileparts (which ('effectsOfModel'))));
%! Case.models = struct ('name', {'Heap', 'SlotBin'});
%! for k = 1:2
%!   Case.models(k).folder = fullfile (root, 'DEMmodels', Case.models(k).name);
%! end
%! Case.effects = resolveEffects ({'opening', 'tilt', 'speedError'});
%! texts = unexpressedEffects (Case);
%! assert (texts, {'no bench can express speedError', ...
%!                 'Heap cannot express opening'});

%!assert (unexpressedEffects (struct ('models', struct ('folder', {}), ...
%!                                    'effects', [])), {})
