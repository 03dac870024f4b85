% CASEEFFECTS  Makes sure that a case knows its candidate effects.
%
% CALL: CASE = caseEffects (CASE)
%
%   CASE   see newCase; where its effects are empty, loadEffects is asked, and
%          every effect is completed from the library
%
% See also: loadEffects, resolveEffects, diagnoseGap

function Case = caseEffects (Case)
  list = Case.effects;
  if isempty (list) && ~isempty (which ('loadEffects'))
    list = loadEffects ();
  end
  if isempty (list) || ~isfield (list, 'priorScale')
    list = resolveEffects (list, fullfile (Case.folder, 'effects'));
  end
  Case.effects = list;
  Case.effectVars = {};
  if ~isempty (list)
    Case.effectVars = [list.variables];
  end
end
