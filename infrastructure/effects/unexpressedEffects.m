% UNEXPRESSEDEFFECTS  Which candidate effects which benches cannot express.
%
% CALL: [TEXTS, NOWHERE] = unexpressedEffects (CASE)
%
% CASE     see newCase; effects as of resolveEffects
% TEXTS    1 x n cell, one line a bench that misses an effect; to be said before
%          any run. Effects that no bench can express come first.
% NOWHERE  1 x e logical: no bench can express the effect
function [texts, nowhere] = unexpressedEffects (Case)
  texts = {};
  nowhere = false (1, numel (Case.effects));
  models = Case.models;
  if isempty (Case.effects) || isempty (models)
    return
  end
  names = {Case.effects.name};
  can = false (numel (models), numel (names));
  for k = 1:numel (models)
    if ~isfolder (models(k).folder)
      % its runs are in a table, whose columns are no matter here
      mine = strcmp ({Case.targets.modelName}, models(k).name);
      can(k, :) = effectsOfModel ('', Case.effects, ...
                                  targetInfo (Case)(mine)) | ...
                  ~[Case.effects.laboratory];
      continue
    end
    can(k, :) = effectsOfModel (models(k).folder, Case.effects);
    if isfield (models, 'readings') && ~isempty (models(k).readings)
      % measured.csv may read a curve at places that results.csv does not list
      mine = strcmp ({Case.targets.modelName}, models(k).name);
      can(k, :) = can(k, :) | ...
                  effectsOfModel (models(k).folder, Case.effects, ...
                                  targetInfo (Case)(mine));
    end
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
%! [~, nowhere] = unexpressedEffects (Case);
%! assert (nowhere, logical ([0, 0, 1]));

%!assert (unexpressedEffects (struct ('models', struct ('folder', {}), ...
%!                                    'effects', [])), {})
%!test
%! % a curve of measured.csv that results.csv has in one line
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'data.head'), "variable a equal 1\n");
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              "name,kind,unit,series,at,text\ntimeMass,mass,kg,,,x\n");
%! Case.effects = resolveEffects ({'timeOffset'});
%! Case.models = struct ('name', 'A', 'folder', folder, 'readings', []);
%! Case.targets = struct ('model', 1, 'modelName', 'A', 'index', {1, 2}, ...
%!                        'name', {'m@1', 'm@2'}, 'result', 'timeMass', ...
%!                        'series', 'timeMass', 'at', {1, 2}, 'unit', '');
%! bare = unexpressedEffects (Case);
%! Case.models.readings = struct ('result', {'timeMass', 'timeMass'});
%! texts = unexpressedEffects (Case);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! assert (bare, {'no bench can express timeOffset'});
%! assert (isempty (texts));

% SPDX-License-Identifier: GPL-3.0-only
