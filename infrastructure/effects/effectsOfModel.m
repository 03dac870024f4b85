% EFFECTSOFMODEL  Says which effects a bench can express, before any run.
%
% CALL: [CAN, REASON] = effectsOfModel (FOLDER, EFFECTS)
%       [CAN, REASON] = effectsOfModel (FOLDER, EFFECTS, INFO)
%
% FOLDER   model folder
% EFFECTS  1 x e struct array of resolveEffects, or []
% INFO     1 x T struct array, what the results are (default: resultInfo)
% CAN      1 x e logical: data.head declares all variables of the effect; an
%          effect of the laboratory acts on one of the results
% REASON   1 x e cell of texts, '' where CAN is true
function [can, reason] = effectsOfModel (folder, effects, info)
  if nargin < 3
    info = resultInfo (folder);
  end
  declared = {checkHead(folder).name};
  [~, model] = fileparts (folder);
  reason = repmat ({''}, 1, numel (effects));
  for k = 1:numel (effects)
    if effects(k).laboratory
      reason{k} = whyNotLaboratory (effects(k), info, model);
    else
      missing = setdiff (effects(k).variables, declared);
      if ~isempty (missing)
        reason{k} = sprintf (['%s cannot express %s: its data.head does ' ...
                              'not declare %s'], model, effects(k).name, ...
                             strjoin (missing, ', '));
      end
    end
  end
  can = cellfun (@isempty, reason);
end

function reason = whyNotLaboratory (effect, info, model)
  reason = '';
  if isempty (info)
    reason = sprintf (['%s cannot express %s: it has no results.csv that ' ...
                       'says what its results are'], model, effect.name);
  elseif isempty (effect.transform)
    reason = sprintf ('%s has no transform', effect.name);
  else
    trial = 1:numel (info);
    acts = @(strength) ~isequal (effect.transform (trial, strength, info), ...
                                 trial);
    if ~any (arrayfun (acts, effect.limits))
      reason = sprintf (['%s cannot express %s: it acts on none of its ' ...
                         'results'], model, effect.name);
    end
  end
end

%!shared folder
%! folder = tempname ();
%! mkdir (folder);
%! fid = fopen (fullfile (folder, 'data.head'), 'w');
%! fputs (fid, "variable tiltAngle equal 0\n");
%! fclose (fid);

%!test % one it can, one it cannot, one that has no information
%! [can, reason] = effectsOfModel (folder, ...
%!                                 resolveEffects ({'tilt', 'drag', 'gain'}));
%! assert (can, [true, false, false]);
%! assert (~isempty (strfind (reason{2}, 'dragRate')));
%! assert (~isempty (strfind (reason{3}, 'results.csv')));

%!test % none asked
%! assert (size (effectsOfModel (folder, [])), [1, 0]);
%! delete (fullfile (folder, 'data.head'));
%! rmdir (folder);
