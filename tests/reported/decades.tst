% A Young's modulus from 1e5 to 1e9 Pa: of 1,000 sets that were said to fit none
% did, and the set that is right lay outside its own interval. The truth is
% E = 1e6, mu = 0.4 (targets 54 and 29.27); scatter 0.2 and 0.3. One seed: the
% numbers are the same at every start.

%!shared folder, c
%! folder = reportedCase ('decades');

%!test
%! [status, out] = startCommand (folder, 'check');
%! assert (status, 0);
%! assert (any (strfind (out, 'E: counted in logarithms')));
%! assert (isempty (strfind (out, 'mu: counted in logarithms')));

%!test <*47>
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, '%s', out);
%! c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%! assert (c.converged);
%! assert (c.scale, struct ('E', 'log', 'mu', 'linear'));
%! assert (c.limits.E, [1e5; 1e9]);

%!test <*47>
%! % the set lies in the intervals, which are narrow, the truth in them or near: a 90 %
%! % interval misses it in one case of ten, twice that width in one of a thousand, and
%! % another Octave draws another sample
%! logs = @(c) log10 ([c.E(:), c.mu(:)]);
%! [known, set] = deal (logs (c.interval90), logs (c.params));
%! assert (all (known(1, :) <= set & set <= known(2, :)));
%! middle = mean (known, 1);
%! assert (all (abs (log10 ([1e6, 0.4]) - middle) < diff (known)));
%! assert (c.interval90.E(2) < 2.5 * c.interval90.E(1));

%!test <*47>
%! % most of what is said to fit meets both targets (none did); the others
%! % are as far off as the scatter of a run, 0.3, that the targets have too
%! P = dlmread (fullfile (folder, 'results', 'posterior.csv'), ',', 1, 0);
%! [E, mu] = deal (P(:, 1), P(:, 2));
%! Z = [20 + 5 * log10(E) + 10 * mu, ...
%!      100 * exp(-3 * mu) ./ (1 + E / 1e7).^0.3];
%! fits = all (abs (Z ./ [54, 29.27] - 1) <= [0.02, 0.03], 2);
%! assert (mean (fits) > 0.5);

%!test
%! % a kept surrogate needs no toolbox, and counts in logarithms, too
%! addpath (fullfile (folder, 'KrigingFuns'));
%! tidy = onCleanup (@() rmpath (fullfile (folder, 'KrigingFuns')));
%! s = loadSurrogate (fullfile (folder, 'KrigingFuns', 'KM_fun_1.txt'));
%! P = [1e5, 0.1; 1e6, 0.4; 3e8, 0.7; 1e9, 0.9];
%! assert (KM_fun_1 (P), predictSurrogate (s, P), 1e-9);

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
