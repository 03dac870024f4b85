% Issue 72, 3: matrices of a user's own: runs in another unit than the limits named a
% cause that was not there, misspelt fields were ignored, missing ones gave the words of
% Octave.

%!shared given, data, quick
%! rand ('twister', 5);
%! randn ('twister', 5);
%! n = 30;
%! data.X = [0.2 + 0.5 * rand(n, 1), 0.02 + 0.2 * rand(n, 1)];
%! data.E = [zeros(14, 1); 40 * rand(16, 1)];
%! slopes = [-6, 15, 10, 0.3; -4, 30, 20, -0.5; -0.05, 0.22, 0.02, 0.006];
%! law = @(X, E) [12, 18, 20, 0.5] + [X, E] * slopes;
%! noise = [0.15, 0.5, 0.3, 0.01];
%! data.Z = law (data.X, data.E) + noise .* randn (n, 4);
%! given = struct ('value', law ([0.45, 0.1], 0), 'sd', [0.1, 0.3, 0.2, 0.005], ...
%!                 'limits', [0.2, 0.02; 0.7, 0.22], 'bench', [1, 1, 2, 2]);
%! given.effects = struct ('name', 'cohesion', 'variables', {{'ced'}}, 'neutral', 0, ...
%!                         'limits', [0; 40]);
%! quick = struct ('bootstrap', 49, 'twins', 60);
%!test
%! % without replicate; the plain runs alone, without E
%! d = diagnoseMatrices (given, data, quick);
%! assert (d.which.verdict, 'no gap');
%! bare = rmfield (structfun (@(A) A(1:14, :), data, 'UniformOutput', false), 'E');
%! d = diagnoseMatrices (given, bare, quick);
%! assert (! strcmp (d.which.verdict, 'named'));
%!test
%! % percent, another order of the columns, a field of another name
%! percent = setfield (data, 'X', data.X .* [100, 1]);
%! turned = setfield (data, 'X', fliplr (data.X) + [0, 1]);
%! wrong = {given, percent, 'none of 30 .p1: 2'; given, turned, 'p2: 1.2'; ...
%!          setfield(given, 'roles', {{'calibrate'}}), data, 'got roles'; ...
%!          setfield(given, 'Sd', 1), data, 'got Sd. Did you mean sd'; ...
%!          given, setfield(data, 'z', 1), 'got z. Did you mean Z'; ...
%!          given, rmfield(data, 'Z'), 'missing: Z'; ...
%!          setfield(given, 'limits', [0, 0.02; 100, 0.22]), data, 'column 1 .*times 100'; ...
%!          given, setfield(data, 'X', [data.X(:, 1) .* [100 * ones(27, 1); ones(3, 1)], ...
%!                                      data.X(:, 2)]), 'column 1 .*times 0.01'; ...
%!          given, setfield(data, 'Z', data.Z .* [1, 1, NaN, 1]), 'column 3 of DATA.Z'; ...
%!          rmfield(given, 'bench'), data, 'missing: bench'};
%! for row = wrong'
%!   fail ('diagnoseMatrices (row{1:2}, quick)', row{3});
%! end

% SPDX-License-Identifier: GPL-3.0-only
