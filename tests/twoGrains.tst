% Two grains, or a grain and a wall, pulled apart in LIGGGHTS: the force over
% the gap of each law of attraction against its formula (tests/twoGrains).

%!function [gap, force] = pulled (set)
%!  % 2 mm grains that do not lose energy; the repulsion of Hertz is taken off
%!  root = fileparts (fileparts (which ('benchTrial')));
%!  [text, fault] = benchTrial (fullfile (root, 'tests', 'twoGrains'), set);
%!  assert (fault, '');
%!  numbers = sscanf (text(index (text, "force_N\n") + 8:end), '%g,%g');
%!  [gap, force] = deal (numbers(1:2:end), numbers(2:2:end));
%!  assert (min (gap) < -1e-5 && max (gap) > 4e-4);
%!  young = [5e6, 1 / (1 / 5e6 + 1 / 5e8)](1 + isfield (set, 'wall')) / 0.91;
%!  young = young / [2, 1](1 + isfield (set, 'wall'));
%!  radius = [1e-3, 2e-3](1 + isfield (set, 'wall'));
%!  force = force - 4 / 3 * young * sqrt (radius) * max (-gap, 0) .^ 1.5;
%!endfunction

%!function check (set, formula)
%!  [gap, force] = pulled (set);
%!  expected = formula (gap);
%!  assert (force, expected, 1e-6 * max ([abs(expected); 1e-3]));
%!endfunction

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % without attraction nothing but Hertz is left
%! check (struct (), @(gap) zeros (size (gap)));
%! check (struct ('wall', 1), @(gap) zeros (size (gap)));

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % DMT: 2 pi R* w wherever the two touch, R* = 1 mm, at a wall 2 mm
%! check (struct ('adhesionPP', 0.1), @(gap) -2e-4 * pi * (gap < 0));
%! check (struct ('adhesionPW', 0.1, 'wall', 1), @(gap) -4e-4 * pi * (gap < 0));
%! % of the other pair nothing
%! check (struct ('adhesionPW', 0.1), @(gap) zeros (size (gap)));

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % SJKR: energy density x area of the circle of intersection; none at gap 0
%! k = 6e4;
%! r = @(gap) 4e-3 + gap;
%! check (struct ('cohesionPP', k), ...
%!        @(gap) -k * pi * (4e-6 - r(gap) .^ 2 / 4) .* (gap < 0));
%! check (struct ('cohesionPW', k, 'wall', 1), ...
%!        @(gap) -k * pi * (4e-6 - (2e-3 + gap) .^ 2) .* (gap < 0));

%!function F = bridge (gap, content, viscosity, speed)
%!  % Soulie 2006 at contact angle 0, with its volume as easo takes it, and Nase
%!  % 2001: 6 pi mu R*^2 v / h, h not below 0.01 R*
%!  R = 2e-3;
%!  volume = 4 / 3 * pi * R ^ 3 * content * (1 - sqrt (0.75));
%!  h = max (gap, 0);
%!  A = -1.1 * (volume / R ^ 3) ^ -0.53;
%!  B = -0.0082 * log (volume / R ^ 3) + 0.48;
%!  C = 0.0018 * log (volume / R ^ 3) + 0.078;
%!  F = -pi * 0.072 * R * (exp (A * h / R + B) + C) - ...
%!      6 * pi * viscosity * speed * 1e-6 ./ max (1e-5, h);
%!  F(gap > volume ^ (1 / 3)) = 0;
%!endfunction

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! % bridges: water; a liquid of 50 times its viscosity, whose viscous part is
%! % four times the capillary one at contact; the largest content, to its end
%! check (struct ('liquidContent', 0.01), ...
%!        @(gap) bridge (gap, 0.01, 1e-3, 0.05));
%! check (struct ('liquidContent', 0.01, 'liquidViscosity', 0.05), ...
%!        @(gap) bridge (gap, 0.01, 0.05, 0.05));
%! check (struct ('liquidContent', 0.02, 'speed', 0.1), ...
%!        @(gap) bridge (gap, 0.02, 1e-3, 0.1));

% SPDX-License-Identifier: GPL-3.0-only
