% Every foreign laboratory goes through the same tests: layout, neutral effects,
% seeds, and results a little outside of the box, as slopes need them.

%!function walk (check)
%!  for number = 1:4
%!    lab = foreignLab (number);
%!    check (lab, columns (lab.problem.limits), ...
%!           numel (lab.problem.effects), numel (lab.noiseSd));
%!  end
%!endfunction

%!function layout (lab, p, K, T)
%!  problem = lab.problem;
%!  assert (p >= 3 && p <= 6 && K >= 6 && K <= 12);
%!  assert (size (lab.bare (rand (5, p))), [5, T]);
%!  assert (cellfun (@numel, {problem.bench, problem.sd, ...
%!                            problem.series, problem.coordinate}), ...
%!          T * ones (1, 4));
%!  assert (unique (problem.bench), 1:numel (problem.benchNames));
%!  assert (numel (problem.names), p);
%!  assert (all (lab.noiseSd > 0) && all (problem.sd > 0));
%!  assert (numel (lab.isSigned), K);
%!  assert (numel (unique ({problem.effects.name})), K);
%!  assert (all ([problem.effects(~lab.isSigned).laboratory] == 0));
%!endfunction

%!function neutral (lab, p, K, T)
%!  theta = rand (20, p);
%!  assert (lab.means (theta, zeros (20, K)), lab.bare (theta));
%!endfunction

%!function everyEffectActs (lab, p, K, T)
%!  theta = 0.5 * ones (1, p);
%!  whole = sqrt (lab.noiseSd.^2 + lab.problem.sd.^2);
%!  for k = 1:K
%!    for side = [1, -ones(1, lab.isSigned(k))]
%!      shape = lab.means (theta, side * ((1:K) == k)) - lab.bare (theta);
%!      assert (norm (shape ./ whole) > 0.05);
%!    end
%!  end
%!endfunction

%!function finite (lab, p, K, T)
%!  theta = 1.04 * rand (100, p) - 0.02;
%!  for k = 1:K
%!    Z = lab.means (theta, rand (100, 1) * ((1:K) == k));
%!    assert (isreal (Z) && all (isfinite (Z(:))));
%!  end
%!endfunction

%!function seeds (lab, p, K, T)
%!  for i = 1:2
%!    randn ('twister', 9);
%!    y(i, :) = lab.measure (0.3 * ones (1, p), zeros (1, K));
%!  end
%!  assert (y(1, :), y(2, :));
%!  another = lab.measure (0.3 * ones (1, p), zeros (1, K));
%!  assert (all (another ~= y(1, :)));
%!endfunction

%!test rand ('twister', 1); walk (@layout);
%!test rand ('twister', 1); walk (@neutral);
%!test walk (@everyEffectActs);
%!test rand ('twister', 1); walk (@finite);
%!test walk (@seeds);

% SPDX-License-Identifier: GPL-3.0-only
