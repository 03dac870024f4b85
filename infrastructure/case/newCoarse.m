% NEWCOARSE  Levels of a case, one element a variable.
%
% CALL: COARSE = newCoarse (GIVEN)
%
%   GIVEN   Input.coarse: cell, element k for model k: [] or a struct with
%           variable (text) and levels (1 x L, the last one counts)
%   COARSE  1 x v struct: variable, levels, models (numbers)
%
% See also: newCase, checkLevels

function coarse = newCoarse (given)
  coarse = struct ('variable', {}, 'levels', {}, 'models', {});
  for k = find (~cellfun (@isempty, given(:)'))
    own = given{k};
    at = find (strcmp ({coarse.variable}, own.variable));
    if isempty (at)
      at = numel (coarse) + 1;
      coarse(at) = struct ('variable', own.variable, 'levels', ...
                           double (own.levels(:)'), 'models', []);
    end
    coarse(at).models(end + 1) = k;
  end
end

%!test
%! own = struct ('variable', 'scaleP', 'levels', [3; 2]);
%! assert (newCoarse ({[], own, own}), ...
%!         struct ('variable', 'scaleP', 'levels', [3, 2], 'models', [2, 3]));
%! assert (isempty (newCoarse ({})));
