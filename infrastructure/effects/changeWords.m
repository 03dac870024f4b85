% CHANGEWORDS  Whether effects can have changed between two measurements.
%
% CALL: [WORDS, FACTORS] = changeWords (EFFECTS)
%
%   EFFECTS  1 x e struct of resolveEffects
%   WORDS    1 x e cell: 'yes', 'unlikely' or 'no'; what the user says in
%            canChange, else what the library expects of the same grains
%   FACTORS  1 x e, what the prior probability is multiplied by: 1, 0.05, 0
%
% Grains that stay the same keep their friction, shape, size and restitution;
% water, fill, tilt, an opening, an instrument or a wall can have changed.
%
% See also: describeEffect, hypothesisTable

function [words, factors] = changeWords (effects)
  words = cell (1, numel (effects));
  for k = 1:numel (effects)
    words{k} = givenField (effects(k), 'canChange', '');
    if isempty (words{k})
      words{k} = givenField (effects(k), 'usually', 'yes');
    end
  end
  [~, at] = ismember (words, {'yes', 'unlikely', 'no'});
  factors = [1, 0.05, 0];
  factors = factors(at);
end

%!test
%! own = struct ('name', 'a', 'variables', {{'q'}}, 'neutral', 0, ...
%!               'limits', [0; 1]);
%! no = setfield (setfield (own, 'name', 'b'), 'variables', {'r'});
%! no.canChange = 'no';
%! effects = resolveEffects ({'rolling', 'tilt', own, no, ...
%!                            struct('name', 'shape', 'canChange', 'yes')});
%! [words, factors] = changeWords (effects);
%! assert (words, {'unlikely', 'yes', 'yes', 'no', 'yes'});
%! assert (factors, [0.05, 1, 1, 0, 1]);
%!assert (changeWords ([]), cell (1, 0))

% SPDX-License-Identifier: GPL-3.0-only
