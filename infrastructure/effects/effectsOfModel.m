% EFFECTSOFMODEL  Says which effects a bench can express, before any run.
%
% CALL: CAN = effectsOfModel (FOLDER, EFFECTS)
%       CAN = effectsOfModel (FOLDER, EFFECTS, INFO)
%
% FOLDER   model folder, or cell of them: one of them can
% EFFECTS  1 x e struct array of resolveEffects, or [], or cell of names
% INFO     1 x T struct array, what the results are (default: resultInfo)
% CAN      1 x e logical: data.head declares all variables of the effect; an
%          effect of the laboratory acts on one of the results
function can = effectsOfModel (folder, effects, info)
  if iscellstr (effects)
    effects = resolveEffects (effects);
  end
  if iscell (folder)
    can = cellfun (@(f) effectsOfModel (f, effects), folder(:), 'UniformOutput', false);
    can = any (vertcat (false (1, numel (effects)), can{:}), 1);
    return
  end
  if nargin < 3
    info = resultInfo (folder);
  end
  declared = {checkHead(folder).name};
  can = false (1, numel (effects));
  for k = 1:numel (effects)
    if effects(k).laboratory
      can(k) = actsOn (effects(k), info);
    else
      can(k) = all (ismember (effects(k).variables, declared));
    end
  end
end

function yes = actsOn (effect, info)
  trial = 1:numel (info);
  acts = @(strength) ~isequal (effect.transform (trial, strength, info), ...
                               trial);
  yes = ~isempty (info) && ~isempty (effect.transform) && ...
        any (arrayfun (acts, effect.limits));
end

%!shared folder
%! folder = emptyFolder ();
%! fid = fopen (fullfile (folder, 'data.head'), 'w');
%! fputs (fid, "variable tiltAngle equal 0\n");
%! fclose (fid);

%!test % one it can, one it cannot, one that has no information
%! can = effectsOfModel (folder, resolveEffects ({'tilt', 'drag', 'gain'}));
%! assert (can, [true, false, false]);

%!test % none asked
%! assert (size (effectsOfModel (folder, [])), [1, 0]);
%! delete (fullfile (folder, 'data.head'));
%! rmdir (folder);

% SPDX-License-Identifier: GPL-3.0-only
