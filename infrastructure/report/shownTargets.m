% SHOWNTARGETS  Targets that the report draws one by one.
%
% CALL: SHOWN = shownTargets (CASE)
%
%   CASE   see newCase
%   SHOWN  1 x n, numbers of targets: all but the points of curves, and of each
%          curve the first one, the middle one and the last one

function shown = shownTargets (Case)
  shown = 1:numel (Case.targets);
  if ~isfield (Case.targets, 'curve')
    return
  end
  curve = [Case.targets.curve];
  keep = curve == 0;
  for c = unique (curve(curve > 0))
    own = find (curve == c);
    [~, order] = sort ([Case.targets(own).at]);
    few = round (linspace (1, numel (own), min (3, numel (own))));
    keep(own(order(few))) = true;
  end
  shown = shown(keep);
end

%!assert (shownTargets (struct ('targets', struct ('name', {'a'}))), 1)
%!test
%! Case.targets = struct ('curve', {0, 1, 1, 1, 1, 1, 2}, ...
%!                        'at', {NaN, 5, 4, 3, 2, 1, 7});
%! assert (shownTargets (Case), [1, 2, 4, 6, 7]);
