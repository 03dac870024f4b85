% CHECKLEVELS  Checks the levels of Input.coarse against the rest of the input.
%
% CALL: P = checkLevels (RAW)
%
%   RAW  see checkCase
%   P    1 x n faults, see checkFault
%
% A level is no design variable; where modelVars names it, with the last level;
% one variable has the same levels for all models that share it; method
% 'published' knows no levels.
%
% Reasons: levelAssigned levelFixed levelsDiffer levelMethod
%
% See also: checkCoarse, newCoarse

function p = checkLevels (raw)
  p = checkFault ();
  if ~isstruct (raw.Input) || ~isfield (raw.Input, 'coarse') || ...
     ~iscell (raw.Input.coarse) || ~isempty (checkCoarse (raw.Input, 0))
    return
  end
  given = raw.Input.coarse(~cellfun (@isempty, raw.Input.coarse));
  seen = struct ();
  for k = 1:numel (given)
    p = [p, checkVariable(given{k}, raw)];
    name = given{k}.variable;
    if isfield (seen, name) && ~isequal (seen.(name), given{k}.levels(:))
      p = [p, checkFault('levelsDiffer', 'Input.coarse', ...
                         ['the same levels of ', name, ' for each model'], ...
                         checkShow (given{k}.levels), ...
                         'A variable is written into all models of a run.')];
    end
    seen.(name) = given{k}.levels(:);
  end
  if ~isempty (given) && isstruct (raw.optim) && ...
     isfield (raw.optim, 'method') && isequal (raw.optim.method, 'published')
    p = [p, checkFault('levelMethod', 'optim.method', ...
                       'robust, where Input.coarse gives levels', ...
                       checkShow (raw.optim.method), ...
                       'Leave out optim.method or Input.coarse.')];
  end
end

function p = checkVariable (own, raw)
  p = checkFault ();
  name = own.variable;
  if iscell (raw.assign) && any (strcmp (name, raw.assign))
    p = checkFault ('levelAssigned', 'Input.coarse', ...
                    'a variable that is not in assign', name, ...
                    'A variable is either calibrated or a level.');
  elseif isstruct (raw.modelVars) && isfield (raw.modelVars, name) && ...
         ~isequal (raw.modelVars.(name), own.levels(end))
    p = checkFault ('levelFixed', ['modelVars.', name], ...
                    sprintf ('the last level, %g', own.levels(end)), ...
                    checkShow (raw.modelVars.(name)), ...
                    ['Take it out: the last level is the one that the ', ...
                     'calibration is for.']);
  end
end

%!function id = firstOf (levels, change)
%!  raw = standInCase (tempname ());
%!  raw.Input.coarse = levels;
%!  p = checkLevels (change (raw));
%!  id = '-';
%!  if ~isempty (p)
%!    id = regexprep (p(1).id, '.*:', '');
%!  end
%!endfunction
%!test
%! good = struct ('variable', 'scaleP', 'levels', [2, 1]);
%! same = @(raw) raw;
%! assert (firstOf ({good}, same), '-');
%! assert (firstOf ({setfield(good, 'variable', 'a')}, same), 'levelAssigned');
%! fix = @(v) @(raw) setfield (raw, 'modelVars', 'scaleP', v);
%! assert (firstOf ({good}, fix (2)), 'levelFixed');
%! assert (firstOf ({good}, fix (1)), '-');
%! assert (firstOf ({good, setfield(good, 'levels', [3, 1])}, same), ...
%!         'levelsDiffer');
%! assert (firstOf ({good}, @(raw) setfield (raw, 'optim', 'method', ...
%!                                           'published')), 'levelMethod');
