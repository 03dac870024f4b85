% WITHLEVELS  Lets the levels of a case ride through its runs and tables.
%
% CALL: CASE = withLevels (CASE)
%
%   CASE  see newCase: its coarse says which levels there are; comes back with
%         them in effects and effectVars
%
% How coarse a run is, travels as the value of an effect does: neutral is the
% last level, the one that counts.
%
% See also: newCoarse, withEffects, withoutLevels, newPlan

function Case = withLevels (Case)
  Case.effects = [];
  for own = Case.coarse
    effect = struct ('name', own.variable, 'variables', {{own.variable}}, ...
                     'neutral', own.levels(end), ...
                     'limits', [min(own.levels); max(own.levels)]);
    Case.effects = [Case.effects, describeEffect(effect)];
  end
  Case.effectVars = {Case.coarse.variable};
  [Case.models.coarse] = deal (Case.coarse);
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! assert (isempty (withLevels (Case).effects));
%! levels = struct ('variable', 'scaleP', 'levels', [3, 2]);
%! Case.coarse = newCoarse ({[], levels});
%! Case = withLevels (Case);
%! assert (Case.effectVars, {'scaleP'});
%! assert (neutralEffects (Case), 2);
%! assert (Case.models(1).coarse, Case.coarse);
