% Issue 47, 17 and 18: a target in grams, limits of +-1e308, a plan of 1e5 sets.

%!test
%! folder = reportedCase ('stale');
%! file = fullfile (folder, 'loadInput.m');
%! text = fileread (file);
%! writeAtomic (file, strrep (text, '[0.0 0.0; 1.0 2.0]', ...
%!                            '[-1e308 0.0; 1e308 2.0]'));
%! [status, out] = startCommand (folder, 'check');
%! assert (status != 0);
%! assert (! isempty (strfind (out, 'numbers of a size that can be')), out);
%! % kg were simulated, g measured: the trial says so
%! writeAtomic (file, strrep (text, '[4, 1.9, 1.5]', '[4000, 1.9, 1.5]'));
%! [status, out] = startCommand (folder, 'check --try');
%! assert (status == 0, out);
%! assert (! isempty (regexp (out, ['WARNING   M_1: measured 4000, 4.33\d* in this ' ...
%!                                  'run: a factor of about 1000, as between g and kg'])), out);
%! assert (numel (strfind (out, 'Are both in one unit')), 1);
%!test
%! plan = GenerateExperPlan ([0, 1; 1, 3], 1e5);
%! assert (size (plan), [1e5, 2]);
%! assert (sort (floor (1e5 * plan(:, 1))), (0:1e5 - 1)');

% SPDX-License-Identifier: GPL-3.0-only
