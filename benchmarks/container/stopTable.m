% STOPTABLE  Tries criteria for the end of the discharge on stored curves.
%
% CALL: T = stopTable (FILE)
%
% FILE  text, what lift100Stop writes
% T     struct array, one a criterion and set: criterion, set, seconds (when it
%       ends, mean), relative (its mass over that at the end of the curve,
%       less one, mean), bias and rms (of the difference, over the scatter of
%       the latter from packing to packing), saved (share of the core time of
%       the run)
%
% Criteria, each judged at every stored time: so many seconds; fewer than n
% spheres gone in the last 0.2 s; energy below so many m g r; and so many
% seconds with two corrections: by a ratio that is learned on the other set
% (what it does to a set that it has not seen), and by the run's own flow, which
% goes on to fall as it did in the last two half seconds. Where a criterion is
% not met the run goes to the end of its curve. Without output prints a table.
%
% See also: lift100Stop

function T = stopTable (file)
  fid = fopen (file);
  data = textscan (fid, '%s %f %f %f %f %f %f', 'Delimiter', ',', ...
                   'HeaderLines', 1);
  fclose (fid);
  curves = splitRuns (data{1}, [data{2:end}]);
  T = struct ([]);
  for rule = rules ()'
    for set = unique ({curves.set})
      T = [T, judge(rule, curves, set{1})];
    end
  end
  if nargout == 0
    sayTable (T);
    clear T;
  end
end

% n x 3 cell: name, handle (curve -> first index), correction
function list = rules ()
  list = cell (0, 3);
  for seconds = [2, 2.5, 3, 3.5, 3.8]
    is = @(c) atTime (c, seconds);
    for correction = {'', ', by ratio', ', by flow'}
      list(end + 1, :) = {[sprintf('%g s', seconds), correction{1}], is, ...
                          correction{1}};
    end
  end
  for n = [1, 2, 5, 10]
    is = @(c) fewGone (c, n);
    list(end + 1, :) = {sprintf('fewer than %d gone in 0.2 s', n), is, ''};
  end
  for energy = [1e-3, 1e-2, 0.1]
    is = @(c) find (c(:, 4) < energy, 1);
    list(end + 1, :) = {sprintf('energy below %g', energy), is, ''};
  end
end

function i = atTime (c, seconds)
  i = find (c(:, 1) > seconds - 0.01, 1);
end

% columns of a curve: time, mass, spheres, energy, core seconds
function i = fewGone (c, n)
  before = [Inf; Inf; c(1:end - 2, 3)];
  i = find (before - c(:, 3) < n, 1);
end

function curves = splitRuns (sets, numbers)
  seeds = arrayfun (@(s) sprintf ('%d', s), numbers(:, 1), ...
                    'UniformOutput', false);
  keys = strcat (sets, '-', seeds);
  [~, first, which] = unique (keys);
  for k = 1:numel (first)
    curves(k) = struct ('set', sets{first(k)}, ...
                        'values', numbers(which == k, 2:end));
  end
end

function row = judge (rule, curves, set)
  isOwn = strcmp ({curves.set}, set);
  [mass, final, seconds, saved] = stopped (rule{2}, curves(isOwn));
  switch rule{3}
    case ', by ratio'
      [other, otherFinal] = stopped (rule{2}, curves(~isOwn));
      mass = mass * mean (otherFinal) / mean (other);
    case ', by flow'
      mass = arrayfun (@(c) byFlow (c.values, rule{2}(c.values)), ...
                       curves(isOwn)(:));
  end
  off = (mass - final) / std (final);
  row = struct ('criterion', rule{1}, 'set', set, ...
                'seconds', mean (seconds), ...
                'relative', mean (mass) / mean (final) - 1, ...
                'bias', mean (off), 'rms', sqrt (mean (off.^2)), ...
                'saved', mean (saved));
end

function [mass, final, seconds, saved] = stopped (find1, curves)
  n = numel (curves);
  [mass, final, seconds, saved] = deal (zeros (n, 1));
  for k = 1:n
    c = curves(k).values;
    ends = [find1(c), rows(c)];
    i = ends(1);
    mass(k) = c(i, 2);
    final(k) = c(end, 2);
    seconds(k) = c(i, 1);
    saved(k) = 1 - c(i, 5) / c(end, 5);
  end
end

% The flow of a half second, times the ratio of the last two for each to come.
function mass = byFlow (c, i)
  flow = -diff (c([i - 10, i - 5, i], 2));
  ratio = min (flow(2) / flow(1), 1);
  halves = (c(end, 1) - c(i, 1)) / 0.5;
  mass = c(i, 2) - flow(2) * sum (ratio.^(1:floor (halves))) - ...
         flow(2) * ratio^ceil (halves) * mod (halves, 1);
end

function sayTable (T)
  heads = {'criterion', 'set', 'ends at', 'mass off by', 'bias / scatter', ...
           'rms / scatter', 'core time saved'};
  printf ("|%s\n|%s\n", sprintf (' %s |', heads{:}), ...
          repmat ('---|', 1, numel (heads)));
  for t = T
    printf ("| %s | %s | %.2f s | %+.1f %% | %+.2f | %.2f | %.0f %% |\n", ...
            t.criterion, t.set, t.seconds, 100 * t.relative, t.bias, ...
            t.rms, 100 * t.saved);
  end
end

%!test
%! % two runs a set, made by hand: one sphere of 1 g goes at each look, core
%! % time runs with the time
%! file = tempname ();
%! time = (0.1:0.1:4)';
%! fid = fopen (file, 'w');
%! fprintf (fid, "head\n");
%! for run = {'a', 'a', 'b', 'b'; 1, 2, 1, 2}
%!   left = 100 + 2 * run{2} - (1:40)';
%!   fprintf (fid, [run{1}, ',', num2str(run{2}), ",%g,%g,%d,1,%g\n"], ...
%!            [time, left / 1e3, left, time]');
%! end
%! fclose (fid);
%! T = stopTable (file);
%! delete (file);
%! T = T(strcmp ({T.criterion}, '3 s') & strcmp ({T.set}, 'a'));
%! assert ([T.seconds, T.saved], [3, 0.25], 1e-9);
%! assert (T.bias, 10 / std ([62, 64]), 1e-9);
