% WITHOUTLEVELS  Makes of a case one that runs at the level that counts alone.
%
% CALL: CASE = withoutLevels (CASE)
%
%   CASE  see newCase, withLevels. coarse stays, so that runs of other levels
%         are known for what they are; modelVars sets the last level where
%         data.head has another value
%
% For the diagnosis: how coarse the model is, is no effect of the material.
%
% See also: diagnoseGap, importRuns

function Case = withoutLevels (Case)
  n = numel (Case.coarse);
  if n == 0
    return
  end
  Case.effects(1:n) = [];
  Case.effectVars(1:n) = [];
  [Case.models.coarse] = deal ([]);
  for own = Case.coarse
    folder = Case.models(own.models(1)).folder;
    if isfolder (folder)
      head = headDefaults (fullfile (folder, 'data.head'));
      Case.modelVars = setLast (Case.modelVars, own, head);
    end
  end
end

function vars = setLast (vars, own, head)
  isDefault = isfield (head, own.variable) && ...
              head.(own.variable) == own.levels(end);
  if ~isDefault
    vars.(own.variable) = own.levels(end);
  elseif isfield (vars, own.variable)
    vars = rmfield (vars, own.variable);
  end
end

%!test
%! % the keys of the runs at the last level are the same with levels and without
%! Case = newCase (standInCase (tempname ()));
%! file = fullfile (Case.models(1).folder, 'data.head');
%! writeAtomic (file, [fileread(file), "\nvariable scaleP equal 2\n"]);
%! for levels = {[3, 2], [4, 3]}
%!   Case.coarse = newCoarse ({struct('variable', 'scaleP', 'levels', ...
%!                                    levels{1})});
%!   one = withLevels (Case);
%!   two = withoutLevels (one);
%!   assert (isempty (two.effects) && isempty (two.effectVars));
%!   assert (newJobs (one, [1, 2], [], 1, 'plan')(1).key, ...
%!           newJobs (two, [1, 2], [], 1, 'plan')(1).key);
%! end
