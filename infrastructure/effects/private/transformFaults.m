% TRANSFORMFAULTS  Tries the transform of an effect of the laboratory.
%
% CALL: P = transformFaults (EFFECT, INFO)
%
%   EFFECT  one effect of resolveEffects with a transform
%   INFO    1 x T struct array of targetInfo
%   P       1 x n faults, see checkFault; reason effectTransform: it stops, gives numbers
%           of another shape or no finite one, changes results at strength 0, or is not affine in
%           them (offset plus matrix, as effectsOfCase takes it)

function p = transformFaults (effect, info)
  p = checkFault ();
  Z = [1:numel(info); (1:numel (info)).^2] + 0.5;
  [~, k] = max (abs (effect.limits));
  try
    of = @(Z, strength) effect.transform (Z, strength, info);
    [made, same] = deal (of (Z, effect.limits(k)), of (Z, 0));
    bent = [of(2 * Z, effect.limits(k)), of(0 * Z, effect.limits(k))];
  catch err
    p = faultOf (effect, ['one that stops: ', strtrim(err.message)]);
    return
  end
  % a curve that is moved has no value beyond its ends
  isNumbers = @(x) isnumeric (x) && isreal (x) && any (isfinite (x(:)));
  isNear = @(a, b) ~any (abs (a(:) - b(:)) > 1e-6 * max (abs ([made(:); Z(:)])));
  if isequal (size (made), size (same), size (Z)) && ~isNumbers ([made, same, bent])
    p = faultOf (effect, 'what is no finite number');
  elseif ~isequal (size (made), size (same), size (Z))
    p = faultOf (effect, sprintf ('%s for results of 2 x %d', describeValue (made), ...
                                  columns (Z)));
  elseif ~isNear (same, Z)
    p = faultOf (effect, 'one that changes results at strength 0');
  elseif ~isNear (bent(:, 1:end / 2) + bent(:, end / 2 + 1:end), 2 * made)
    p = faultOf (effect, 'one that is no sum of an offset and multiples of results');
  end
end

function p = faultOf (effect, got)
  p = checkFault ('effectTransform', ['effects, ', effect.name, ', transform'], ...
                  ['Z = f (Z, strength, info): finite, of the size of Z, Z itself at ' ...
                   'strength 0, affine in Z'], got, ...
                  'Take effectGain.m of the toolbox as a pattern.');
end

%!shared e, info
%! info = struct ('name', {'a', 'b'}, 'kind', {'mass', 'angle'}, 'unit', {'kg', 'deg'}, ...
%!                'series', '', 'at', NaN);
%! e = struct ('name', 'slow', 'limits', [0.01; 0.1]);
%!test
%! for good = {@(Z, s, i) Z * (1 + s), @(Z, s, i) Z + s, @(Z, s, i) Z - s * Z(:, 1)}
%!   e.transform = good{1};
%!   assert (isempty (transformFaults (e, info)));
%! end
%!test
%! for bad = {@(Z, s) Z, @(Z, s, i) nope (Z), @(Z, s, i) Z(:, 1) * (1 + s), ...
%!            @(Z, s, i) NaN * Z, @(Z, s, i) Z + 1, @(Z, s, i) Z + s * Z.^2, ...
%!            @(Z, s, i) num2cell (Z)}
%!   e.transform = bad{1};
%!   p = transformFaults (e, info);
%!   assert (p.id, 'DEcalioc:checkCase:effectTransform');
%! end

% SPDX-License-Identifier: GPL-3.0-only
