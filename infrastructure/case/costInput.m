% COSTINPUT  What a cost function needs of the case.
%
% CALL: GIVEN = costInput (HANDEDON)
%
% HANDEDON  cell: what costFunction was handed besides the set and the
%           evaluate function. DEcalioc hands on its case (see newCase); where
%           no cell is one, loadInput.m of the current folder is read
% GIVEN     struct: value T x 1 (measured, in the order of the results that a
%           cost function gets; NaN: not measured yet), scale T x 1 (what a
%           residual is divided by: the value, or 1 where the tolerance is
%           absolute), modelVars, names 1 x d cell, limits 2 x d, WRL (scalar,
%           0 = no wish for a large time step)
%
% See also: costFunction, newCase, readInput, newTargets

function given = costInput (handedOn)
  isCase = cellfun (@(c) isstruct (c) && isscalar (c) && ...
                    all (isfield (c, {'targets', 'modelVars', 'options'})), ...
                    handedOn);
  if any (isCase)
    first = find (isCase, 1);
    Case = handedOn{first};
    [value, scale] = ofTargets (Case.targets);
    given = struct ('value', value, 'scale', scale, ...
                    'modelVars', Case.modelVars, 'names', {Case.names}, ...
                    'limits', Case.limits, 'WRL', Case.options.WRL);
    return
  end
  raw = readInput ();
  [value, scale] = ofInput (raw);
  given = struct ('value', value, 'scale', scale, ...
                  'modelVars', raw.modelVars, 'names', {raw.assign(:)'}, ...
                  'limits', raw.paramLims, 'WRL', 0);
  if isfield (raw.optim, 'WRL') && ~isempty (raw.optim.WRL)
    given.WRL = raw.optim.WRL;
  end
end

function [value, scale] = ofInput (raw)
  if isfile (fullfile (raw.folder, 'measured.csv'))
    names = cellstr (raw.Input.model)(:)';
    list = readConditions (raw, names);
    found.groups = groupMeasured (list, names);
    [value, scale] = ofTargets (newTargets (raw.optim, names, found));
  else
    value = asColumn (raw.optim.targetVal);
    scale = value;
  end
end

function [value, scale] = ofTargets (targets)
  value = [targets.value]';
  scale = value;
  scale([targets.isAbsolute]) = 1;
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! given = costInput ({{'KM_fun_1'}, Case});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
%! assert (given.value, [400; 0.025; 3]);
%! assert (given.scale, given.value);
%! assert (given.names, {'a', 'b'});
%! assert (given.WRL, 0);
%!test
%! % the toolbox's own case
%! given = costInput ({});
%! assert (given.value, [400; 0.025]);
%! assert (given.WRL, 0.5);
%!test
%! % with a table of measured values, the case handed on and read say the same
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! writeAtomic (fullfile (raw.folder, 'measured.csv'), ...
%!              ["model,name,value,tol\nSecond,b,0,1\nFirst,a,4,0.1\n", ...
%!               "First,c,,\n"]);
%! here = cd (raw.folder);
%! clear loadInput
%! read = costInput ({});
%! cd (here);
%! clear loadInput
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
%! assert (read.value, [4; NaN; 0]);
%! assert (read.scale, [4; NaN; 1]);
