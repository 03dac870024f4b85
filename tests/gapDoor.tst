% Flows of the diagnosis at its door: units, benches without any result.

%!function options = quick ()
%!  options = struct ('twins', 99, 'bootstrap', 199, ...
%!                    'trend', 'affine');
%!endfunction

%!shared given, data, means
%! pkg load stk
%! [given, data, means] = smallGapLab ();
%! randn ('twister', 1);
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0, 0]) + ...
%!               0.2 * sqrt (2) * randn (1, 12);

%!test
%! % the same numbers in every unit: targets, benches, parameters and effects
%! g = given;
%! options = setfield (quick (), 'effective', 200);
%! first = diagnoseMatrices (g, data, options);
%! assert (first.which.verdict, 'named');
%! unit = [1e-9 * ones(1, 4), 10.^(-12:8:12), 1, 1e-3, 7, 1e6];
%! [g.value, g.sd] = deal (g.value .* unit, g.sd .* unit);
%! g.effects(5).offset = g.effects(5).offset .* unit;
%! g.limits = g.limits .* [1e-12, 1e12];
%! own = data;
%! [own.Z, own.X] = deal (data.Z .* unit, data.X .* [1e-12, 1e12]);
%! own.E = data.E .* [1e-12, 1e9, 1e-6, 3];
%! for k = 1:4
%!   g.effects(k).limits = g.effects(k).limits * [1e-12, 1e9, 1e-6, 3](k);
%! end
%! lastwarn ('', '');
%! other = diagnoseMatrices (g, own, options);
%! assert (lastwarn (), '');
%! assert (other.which.verdict, 'named');
%! assert (other.which.effects, first.which.effects);
%! % far beyond what was drawn, from its tail: a power of the statistic
%! assert (other.which.gateP, first.which.gateP, -0.05);
%! assert (other.where.p, first.where.p);
%! assert (other.where.t, first.where.t, 1e-4);
%! assert (other.where.residual ./ unit, first.where.residual, 1e-4);
%! assert (other.where.budget.trial ./ unit, first.where.budget.trial, 1e-4);
%! assert ([other.which.strength.value], [first.which.strength.value], 1e-3);
%! assert (struct2cell (other.which.posterior), ...
%!         struct2cell (first.which.posterior), 1e-3);

%!test
%! % all runs of one bench failed: the others are diagnosed
%! own = data;
%! own.Z(:, 1:4) = NaN;
%! d = diagnoseMatrices (given, own, quick ());
%! assert (d.where.out, {'bench1'});
%! assert (d.problem.targetNames{1}, 't5');
%! assert (d.data, own);
%! assert (any (strcmp ('spread', d.which.effects)));

% SPDX-License-Identifier: GPL-3.0-only
