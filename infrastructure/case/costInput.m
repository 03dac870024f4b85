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
    Case = handedOn{find(isCase, 1)};
  else
    Case = ofFolder (readInput ());
  end
  value = [Case.targets.value]';
  scale = value;
  scale([Case.targets.isAbsolute]) = 1;
  given = struct ('value', value, 'scale', scale, ...
                  'modelVars', Case.modelVars, 'names', {Case.names}, ...
                  'limits', Case.limits(1:2, :), 'WRL', Case.options.WRL);
end

% The same of a case that nobody has checked: a cost function that users call
% themselves has no time for that.
function Case = ofFolder (raw)
  Case = struct ('modelVars', raw.modelVars, 'names', {raw.assign(:)'}, ...
                 'limits', raw.paramLims);
  Case.options.WRL = givenField (raw.optim, 'WRL', inputFields ('defaults').WRL);
  if isfile (fullfile (raw.folder, 'measured.csv'))
    names = cellstr (raw.Input.model)(:)';
    found.groups = groupMeasured (readConditions (raw, names), names, ...
                                  raw.further);
    Case.targets = newTargets (raw.optim, names, found);
  else
    values = checkElements (raw.optim.targetVal, 'optim.targetVal', 'column');
    Case.targets = struct ('value', values, 'isAbsolute', false);
  end
end

%!test
%! Case = readyCase ();
%! given = costInput ({{'KM_fun_1'}, Case});
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
%! assert (read.value, [4; NaN; 0]);
%! assert (read.scale, [4; NaN; 1]);

% SPDX-License-Identifier: GPL-3.0-only
