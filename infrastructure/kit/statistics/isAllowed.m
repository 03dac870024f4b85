% ISALLOWED  Which parameter sets the user allows.
%
% CALL: [YES, P] = isAllowed (P, BOX)
%
% P    n x d, sets; comes back with the nearest of its values for a parameter
%      that has some listed
% BOX  struct: limits (see toUnit), allowed ([] or missing: all are; else struct
%      values, 1 x d cell of the listed values ([]: any), and rules, cell of
%      handles n x d -> n x 1 logical)
% YES  n x 1 logical: the set that comes back satisfies all rules

function [yes, P] = isAllowed (P, box)
  yes = true (rows (P), 1);
  if ~isfield (box, 'allowed') || isempty (box.allowed)
    return
  end
  for j = find (~cellfun (@isempty, box.allowed.values))
    P(:, j) = nearest (P(:, j), box.allowed.values{j}, box.limits(:, j));
  end
  for rule = box.allowed.rules
    yes(yes) = rule{1} (P(yes, :));
  end
end

% Nearest in the unit box.
function x = nearest (x, values, limits)
  values = values(:);
  if ~isscalar (values)
    u = toUnit (values, limits);
    number = lookup ((u(1:end - 1) + u(2:end)) / 2, toUnit (x, limits)) + 1;
    x = values(number);
  end
end

%!shared box
%! box.limits = [0, 1; 1, 100; 0, 1];
%! box.allowed.values = {[], [1, 10, 100]};
%! box.allowed.rules = {@(P) P(:, 1) < P(:, 2) / 10, @(P) P(:, 1) > 0.1};
%!test
%! [yes, P] = isAllowed ([0.5, 4; 0.5, 2; 0.05, 30; 0.2, 32], box);
%! assert (P, [0.5, 10; 0.5, 1; 0.05, 10; 0.2, 100]);
%! assert (yes, [true; false; false; true]);
%!assert (isAllowed ([1, 2; 3, 4], struct ('limits', [])), true (2, 1));
%!assert (isAllowed (zeros (0, 2), box), true (0, 1));

% SPDX-License-Identifier: GPL-3.0-only
