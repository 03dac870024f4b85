% HEADLINECAUSES  Which effects of a verdict may stand in its first words.
%
% CALL: [NAMES, CODE, ALIKE] = headlineCauses (GAP)
%
%   GAP    decoded gap/gap.json
%   NAMES  1 x n cell, the effects of which that carry the verdict
%   CODE   why fewer than the verdict names: 'oneNumber', 'fewNumbers' (two or three
%          numbers, and more than one cause or none left), 'kind' (more than four, all of one
%          kind), 'manyKinds' (more than four, of several), else ''
%   ALIKE  1 x m cell, those that would look almost the same, each without the others:
%          of one class, and left out only as they ride along
%
% None whose strength these tests cannot see, whose interval holds the neutral value
% (it may not act at all), or that explains the measurements mostly beside another
% one. One number tells no causes apart, whatever their ranges make of it.

function [names, code, alike] = headlineCauses (gap)
  which = gap.which;
  names = namesIn (which, 'effects');
  isPair = isequal (jsonAt (which, {'together'}), true);
  names = setdiff (names, namesIn (which, 'cannotSee'), 'stable');
  names = names(cellfun (@(n) ~mayBeNothing (which, n), names));
  isRider = ~isPair & cellfun (@(n) ridesAlong (which, n), names);
  isClass = isequal (jsonAt (which, {'sameKind'}), true);
  alike = names(isRider & isClass);
  names = names(~isRider);
  numbers = numel (followedReadings (gap));
  numbers(numbers == 0) = Inf;             % of a gap the parameters are no change
  code = '';
  if numbers == 1
    [names, code] = deal ({}, 'oneNumber');
  elseif numbers <= 3 && ~isPair && (numel (names) > 1 || isNoneListed (which))
    [names, code] = deal ({}, 'fewNumbers');
  elseif numel (names) > 4
    kinds = unique (cellfun (@(n) kindOf (which, n), names, 'UniformOutput', false));
    code = merge (numel (kinds) > 1 || isempty (kinds{1}), 'manyKinds', 'kind');
  end
end

% That none of the causes fits two or three numbers says little of a list.
function yes = isNoneListed (which)
  yes = strcmp (givenField (which, 'verdict', ''), 'none of the listed');
end

function yes = mayBeNothing (which, name)
  range = jsonAt (which, {'strength', fieldOf(name), 'interval90'});
  yes = numel (range) == 2 && all (isfinite (range)) && range(1) <= 0 && range(2) >= 0;
end

% Less than half of its probability is its own.
function yes = ridesAlong (which, name)
  own = jsonAt (which, {'byItself', fieldOf(name)});
  whole = jsonAt (which, {'posterior', fieldOf(name)});
  yes = ~isempty (own) && own < 0.5 * whole;
end

function kind = kindOf (which, name)
  kind = char (jsonAt (which, {'strength', fieldOf(name), 'kind'}));
end

function name = fieldOf (name)
  name = matlab.lang.makeValidName (name);
end

%!function gap = lab (names, low, alone, kinds, numbers)
%!  gap.which = struct ('effects', {names}, 'cannotSee', {{}}, 'together', false);
%!  for k = 1:numel (names)
%!    gap.which.strength.(names{k}) = struct ('interval90', [low(k), 1], 'kind', kinds{k});
%!    gap.which.posterior.(names{k}) = 0.5;
%!    gap.which.byItself.(names{k}) = alone(k);
%!  end
%!  gap.reference.targets = repmat (struct ('name', 'x'), 1, numbers);
%!endfunction
%!shared names, kinds
%! names = {'a', 'b', 'c', 'd', 'e'};
%! kinds = repmat ({'holds'}, 1, 5);
%!test
%! % may be nothing; rides along; cannot be seen
%! gap = lab (names, [0.1, -1, 0.1, 0.2, 0.2], [0.4, 0.4, 0.2, 0.3, 0.5], kinds, 9);
%! gap.which.cannotSee = {'d'};
%! assert (headlineCauses (gap), {'a', 'e'});
%! gap.which.together = true;
%! assert (headlineCauses (gap), {'a', 'c', 'e'});
%!test
%! % one, two and six numbers; of a gap
%! code = @(n) nthargout (1:2, @headlineCauses, lab (names(1:2), [0.1, 0.1], [1, 1], ...
%!                                                   kinds, n));
%! assert (code (1), {{}, 'oneNumber'});
%! assert (code (2), {{}, 'fewNumbers'});
%! assert (code (6), {names(1:2), ''});
%! none = lab (names(1), 0.1, 1, kinds, 3);
%! none.which.verdict = 'none of the listed';
%! assert (nthargout (2, @headlineCauses, none), 'fewNumbers');
%! assert (code (0), {names(1:2), ''});
%! assert (headlineCauses (lab (names(1), 0.1, 1, kinds, 3)), names(1));
%!test
%! % five causes: their kind, where it is one
%! [many, code] = headlineCauses (lab (names, 0.1 * ones (1, 5), ones (1, 5), kinds, 9));
%! assert ({numel(many), code}, {5, 'kind'});
%! kinds{2} = 'slows';
%! assert (nthargout (2, @headlineCauses, lab (names, 0.1 * ones (1, 5), ones (1, 5), ...
%!                                             kinds, 9)), 'manyKinds');

% SPDX-License-Identifier: GPL-3.0-only
