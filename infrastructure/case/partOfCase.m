% PARTOFCASE  The case with some of its models and their targets alone.
%
% CALL: [PART, OWN] = partOfCase (CASE, IS)
%
%   CASE  see newCase;  IS  1 x M logical, the models that stay
%   PART  struct as CASE, the models of the targets numbered anew
%   OWN   1 x T logical, the targets of CASE that stay

function [part, own] = partOfCase (Case, is)
  part = Case;
  part.models = Case.models(is);
  own = is([Case.targets.model]);
  part.targets = Case.targets(own);
  number = num2cell (cumsum (is)([part.targets.model]));
  [part.targets.model] = number{:};
end

%!test
%! Case.models = struct ('name', {'A', 'B', 'C'});
%! Case.targets = struct ('model', {1, 2, 3, 3}, 'name', {'a', 'b', 'c', 'd'});
%! [part, own] = partOfCase (Case, [true, false, true]);
%! assert ([part.models.name], 'AC');
%! assert ([[part.targets.model]; [part.targets.name]], [1, 2, 2; 'acd']);
%! assert (own, logical ([1, 0, 1, 1]));
