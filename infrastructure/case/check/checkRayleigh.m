% CHECKRAYLEIGH  Checks that the Rayleigh time can be worked out.
%
% CALL: P = checkRayleigh (OPTIM, MODELVARS, ASSIGN, MODELS)
%
%   OPTIM      scalar struct, the optim of loadInput
%   MODELVARS  scalar struct of model variables
%   ASSIGN     1 x d cell of names
%   MODELS     1 x M struct array, see checkFindModels
%   P          1 x n faults, see checkFault
%
% Radius, density, Young's modulus and Poisson's ratio must be among the model
% or the design variables where optim.WRL > 0, or where percentRayleigh is one
% and a data.head would keep its own time step otherwise. With optim.WRL > 0
% percentRayleigh too, where a data.head sets SIMTS to 0 and has no
% percentRayleigh to go by.
%
% Reason: missingRayleigh

function p = checkRayleigh (optim, modelVars, assign, models)
  p = checkFault ();
  isText = cellfun (@(a) checkIs ('text', a), assign);
  given = [fieldnames(modelVars)', assign(isText)];
  isWished = isfield (optim, 'WRL') && checkIs ('number', optim.WRL) && ...
             optim.WRL > 0;
  isLost = any (strcmp (given, 'percentRayleigh')) && ...
           any (arrayfun (@ownStep, models) > 0);
  if ~isWished && ~isLost
    return
  end
  needed = {'radiusP', 'densityP', 'youngsModulusP', 'poissonsRatioP'};
  if isWished && any (arrayfun (@needsPercent, models))
    needed{end + 1} = 'percentRayleigh';
  end
  for k = find (~ismember (needed, given))
    name = needed{k};
    p(end + 1) = checkFault ('missingRayleigh', ['modelVars.', name], ...
                             'a number, or a design variable', ...
                             'neither', cure (name, models));
  end
end

function yes = needsPercent (model)
  yes = ownStep (model) == 0 && ...
        ~any (strcmp ({model.head.name}, 'percentRayleigh'));
end

% SIMTS of data.head (s); NaN where it has none.
function step = ownStep (model)
  step = NaN;
  if isempty (model.head)
    return
  end
  place = find (strcmp ({model.head.name}, 'SIMTS'), 1, 'last');
  if ~isempty (place)
    step = str2double (model.head(place).value);
  end
end

function text = cure (name, models)
  text = sprintf (['Set modelVars.%s; without it optim.WRL must be 0 and ' ...
                   'percentRayleigh not set.'], name);
  heads = [models.head];
  if isempty (heads)
    return
  end
  place = find (strcmp ({heads.name}, name), 1, 'last');
  if ~isempty (place) && ~isnan (str2double (heads(place).value))
    text = sprintf ('Set modelVars.%s = %s; as data.head does.', name, ...
                    heads(place).value);
  end
end

%!shared models
%! head = struct ('name', {'radiusP', 'SIMTS'}, 'style', 'equal', ...
%!                'value', {'2e-3', '0'});
%! models = struct ('head', head);
%!assert (isempty (checkRayleigh (struct ('WRL', 0), struct (), {}, models)))
%!test
%! vars = struct ('youngsModulusP', 5e6, 'poissonsRatioP', 0.3);
%! p = checkRayleigh (struct ('WRL', 0.5), vars, {'densityP'}, models);
%! assert (numel (p), 2);
%! assert (p(1).id, 'DEcalioc:checkCase:missingRayleigh');
%! assert (! isempty (strfind (p(1).message, 'modelVars.radiusP = 2e-3;')));
%! assert (! isempty (strfind (p(2).message, 'percentRayleigh')));
%!test
%! % a share of the Rayleigh time would be lost beside a fixed time step
%! own = models;
%! own.head(2).value = '1e-5';
%! vars = struct ('percentRayleigh', 0.2, 'radiusP', 2e-3, ...
%!                'youngsModulusP', 5e6, 'poissonsRatioP', 0.3);
%! p = checkRayleigh (struct ('WRL', 0), vars, {}, own);
%! assert (numel (p), 1);
%! assert (! isempty (strfind (p.message, 'densityP')));
%! p = checkRayleigh (struct ('WRL', 0), vars, {'densityP'}, own);
%! assert (isempty (p));
