% CHECKEFFECTNUMBERS  Checks the neutral values and limits of one effect.
%
% CALL: P = checkEffectNumbers (EFFECT, FIELD, V)
%
%   EFFECT  scalar struct, one effect of loadEffects
%   FIELD   how the user writes it, e.g. 'effects(2).' (text)
%   V       number of its variables
%   P       1 x n problems, see checkProblem
%
% Reasons: missingField neutralShape effectLimitsShape effectLimits
%
% See also: checkEffects

function p = checkEffectNumbers (effect, field, v)
  p = [checkNeutral(effect, field, v), checkBounds(effect, field, v)];
end

function p = checkNeutral (effect, field, v)
  p = checkProblem ();
  field = [field, 'neutral'];
  expected = sprintf ('%d finite number(s), one a variable', v);
  cure = 'Set the values that switch the effect off.';
  if ~isfield (effect, 'neutral')
    p = checkProblem ('missingField', field, expected, 'nothing', cure);
  elseif ~checkIs ('vector', effect.neutral) || ...
      numel (effect.neutral) ~= v || ~all (isfinite (effect.neutral))
    p = checkProblem ('neutralShape', field, expected, ...
                      checkShow (effect.neutral), cure);
  end
end

function p = checkBounds (effect, field, v)
  p = checkProblem ();
  field = [field, 'limits'];
  expected = sprintf (['a 2 x %d matrix of finite numbers: weakest and ' ...
                       'strongest plausible values'], v);
  cure = 'Set the two rows, one column a variable.';
  if ~isfield (effect, 'limits')
    p = checkProblem ('missingField', field, expected, 'nothing', cure);
    return
  end
  limits = effect.limits;
  if ~isnumeric (limits) || ~isreal (limits) || issparse (limits) || ...
      ~isequal (size (limits), [2, v]) || ~all (isfinite (limits(:)))
    p = checkProblem ('effectLimitsShape', field, expected, ...
                      checkShow (limits), cure);
  elseif all (limits(1, :) == limits(2, :))
    p = checkProblem ('effectLimits', field, ...
                      'a weakest value that is not the strongest', ...
                      checkShow (limits(:)), ...
                      'Set the strongest plausible value in row 2.');
  end
end

%!shared e
%! e = struct ('neutral', [0, 1], 'limits', [0, 1; 5, 0.5]);
%!assert (isempty (checkEffectNumbers (e, 'effects(1).', 2)))
%!assert (checkEffectNumbers (e, 'effects(1).', 1)(1).id, ...
%!        'DEcalioc:checkCase:neutralShape')
%!test
%! bad = setfield (e, 'limits', [1, 2; 1, 2]);
%! assert (checkEffectNumbers (bad, 'effects(1).', 2).id, ...
%!         'DEcalioc:checkCase:effectLimits');
