% DESCRIBEEFFECT  Fills the description of a candidate effect of the library.
%
% CALL: EFFECT = describeEffect (GIVEN)
%
% GIVEN   scalar struct with at least name, neutral (1 x v), limits (2 x v:
%         weakest, strongest plausible value) and, unless laboratory is true,
%         variables (1 x v cell of names that data.head declares)
% EFFECT  scalar struct with all fields:
%           name          short name, the file is effect<Name>.m
%           question      what a user would ask, in plain words
%           variables     1 x v cell, {} for effects of the laboratory
%           neutral       1 x v, values that switch it off (laboratory: 0)
%           limits        2 x v (laboratory: 2 x 1)
%           priorScale    1 x v, a usual distance from neutral
%           unit, label   texts for axes and tables; unit 'factor' is said as
%                 '3 % larger than modelled', 'share' as '3 %'
%           saysName      logical: the label begins with the name, which need not be
%                         said before it (default: where no label is given)
%           group         name of the family that observables can hardly split
%           laboratory    true: acts on results, needs no DEM run
%           kinds         cell of the kinds of results it acts on (laboratory)
%           transform     [] or a handle: Z = transform (Z, strength, info), Z
%                         n x T results, info 1 x T struct array of resultInfo;
%                         affine in Z, linear in strength
%           oneSided      logical: the limits of a case leave out one side of neutral,
%                         on which the library has values, too
%           source        where range and sign come from
%           usually       'yes' or 'unlikely' (properties of the grains
%                         themselves): whether it can have changed between two
%                         measurements of the same grains
%           canChange     '' (as usually), 'yes', 'unlikely' or 'no': what the
%                         user says of it, see changeWords
%
% Which benches see it is measured: benchmarks/results/effectSigns.csv.
%
% A field of another name is the author's own, unless it is nearly one of these.
%
% Throws DEcalioc:describeEffect:missingField, :badShape, :unknownField.
%
% See also: getEffect, listEffects, resolveEffects
function effect = describeEffect (given)
  wanted = {'name', 'neutral', 'limits'};
  missing = wanted(~isfield (given, wanted));
  if ~isempty (missing)
    error ('DEcalioc:describeEffect:missingField', ...
           'describeEffect: GIVEN must have the field %s.', missing{1});
  end
  effect = struct ('name', given.name, 'question', '', 'variables', {{}}, ...
                   'neutral', [], 'limits', [], 'priorScale', [], ...
                   'unit', '', 'label', given.name, ...
                   'saysName', ~isfield (given, 'label'), 'group', given.name, ...
                   'laboratory', false, 'kinds', {{}}, 'transform', [], ...
                   'oneSided', false, ...
                   'source', '', 'usually', 'yes', 'canChange', '');
  names = fieldnames (effect);
  for other = setdiff (fieldnames (given), names)'
    hint = checkNearest (other{1}, names');
    if ~isempty (hint)
      error ('DEcalioc:describeEffect:unknownField', ...
             'describeEffect: effect %s has a field %s, which nothing reads. %s', ...
             given.name, other{1}, hint);
    end
  end
  for k = find (isfield (given, names)).'
    effect.(names{k}) = given.(names{k});
  end
  v = numel (effect.variables);
  if effect.laboratory
    v = 1;
  end
  if ~isequal (size (effect.neutral), [1, v]) || ...
     ~isequal (size (effect.limits), [2, v])
    error ('DEcalioc:describeEffect:badShape', ...
           ['describeEffect: effect %s must have neutral 1 x %d and ' ...
            'limits 2 x %d, got %d x %d and %d x %d.'], effect.name, v, v, ...
           size (effect.neutral), size (effect.limits));
  end
  if isempty (effect.priorScale)
    effect.priorScale = 2 * max (abs (effect.limits - effect.neutral), [], 1);
  end
  effect.limits = orderedLimits (effect.limits, effect.neutral);
end

% Lower one first where it acts both ways. Where neutral lies at an end or outside, the rows
% stay: weakest, strongest.
function limits = orderedLimits (limits, neutral)
  both = min (limits, [], 1) < neutral & neutral < max (limits, [], 1);
  limits(:, both) = sort (limits(:, both), 1);
end

%!test % defaults of a plain effect
%! e = describeEffect (struct ('name', 'x', 'variables', {{'a', 'b'}}, ...
%!                             'neutral', [0, 1], 'limits', [0, 0.5; 2, 4]));
%! assert (e.priorScale, [4, 6]);
%! assert (e.group, 'x');
%! assert (e.laboratory, false);
%! e = describeEffect (struct ('name', 'x', 'variables', {{'a', 'b'}}, ...
%!                             'neutral', [0.5, 5], 'limits', [0.9, 3; 0.2, 1]));
%! assert (e.limits, [0.2, 3; 0.9, 1]);

%!error id=DEcalioc:describeEffect:missingField ...
%! describeEffect (struct ('name', 'x'))
%!error <a field laebl, which nothing reads. Did you mean label\?>
%! describeEffect (struct ('name', 'x', 'neutral', 0, 'limits', [0; 1], 'laebl', 'a'))
%!assert (describeEffect (struct ('name', 'x', 'variables', {{'q'}}, 'neutral', 0, ...
%!                                'limits', [0; 1], 'author', 'me')).name, 'x')
%!error id=DEcalioc:describeEffect:badShape ...
%! describeEffect (struct ('name', 'x', 'neutral', 0, 'limits', [0; 1]))

% SPDX-License-Identifier: GPL-3.0-only
