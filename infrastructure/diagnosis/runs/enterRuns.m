% ENTERRUNS  Lets runs and measurements in: checked, and in units of their own.
%
% CALL: [PROBLEM, DATA] = enterRuns (GIVEN, DATA, OPTIONS)
%
%   GIVEN       see newProblem, in the units of the user
%   DATA        struct X, E, Z (NaN: no result, NA: not run), replicate, and
%               level, see fitEmulator (all 0 where missing)
%   OPTIONS     struct of gapOptions
%   PROBLEM     struct of newProblem, in standard units, less the targets of benches none of
%               whose runs gave a result; also
%     kept (1 x T'): numbers of the targets that are left
%     unit (1 x T'): what one unit is in that of the user, a power of two
%     out  (cellstr): names of the benches that are out (of a change not those without
%       a reading of the new state), and of these neverRun (cellstr): those of which
%       no run has come to its end; lacking (cellstr): targets that a third of the runs
%       lack, three at least, which have other results of the bench. Out, too: those
%       in which something flowed do not stand for all
%   DATA        the same, each run once, Z in standard units, columns as the
%               targets left
%
% A target's unit is near the uncertainty of its measurement: it must not change
% with further runs, or a second start would come to other last digits and ask
% for other sets. A power of two leaves every digit as it is. Beyond this door
% all limits of rounding are relative (tools/lint.sh); parameters and strengths
% are in shares of their ranges anyway.
%
% Errors: DEcalioc:enterRuns:badShape, :badValue, :runFailed, :noRuns

function [problem, data] = enterRuns (given, data, options)
  problem = newProblem (given);
  checkRuns (problem, data);
  data = onceEach (data);
  [there, needed] = neutralRuns (problem, data, options);
  [problem, kept, gone] = withoutDeadBenches (problem, data, there < needed);
  for name = intersect ({'Z', 'level'}, fieldnames (data)')
    data.(name{1}) = data.(name{1})(:, kept);
  end
  checkEnough (problem, there(kept), needed);
  unit = unitsOf (problem, data.Z);
  problem = inUnits (problem, unit);
  problem.kept = kept;
  problem.unit = unit;
  problem = mergeFields (problem, gone);
  data.Z = data.Z ./ unit;
end

function checkRuns (problem, data)
  n = rows (data.X);
  sizes = {'X', [n, columns(problem.limits)]; ...
           'E', [n, columns(data.E)]; ...
           'Z', [n, numel(problem.value)]; 'replicate', [n, 1]};
  for i = 1:rows (sizes)
    value = data.(sizes{i, 1});
    if ~isequal (size (value), sizes{i, 2})
      error ('DEcalioc:enterRuns:badShape', ...
             'enterRuns: DATA.%s must be %d x %d, got %d x %d.', ...
             sizes{i, 1}, sizes{i, 2}, size (value));
    end
    if ~isreal (value)
      error ('DEcalioc:enterRuns:badValue', ...
             'enterRuns: DATA.%s must hold real numbers, got %s.', ...
             sizes{i, 1}, describeValue (value));
    end
  end
  bad = find (~all (isfinite ([data.X, data.E]), 2), 1);
  if ~isempty (bad)
    error ('DEcalioc:enterRuns:badValue', ...
           ['enterRuns: run %d has a parameter or an effect variable that ' ...
            'is not finite. Give the value it was run with, or leave the ' ...
            'run out.'], bad);
  end
  [run, t] = find (isinf (data.Z), 1);
  if ~isempty (run)
    error ('DEcalioc:enterRuns:badValue', ...
           ['enterRuns: run %d gives %g for %s. A run without a result has ' ...
            'NaN there (in runs.csv: nothing).'], run, data.Z(run, t), ...
           problem.targetNames{t});
  end
end

% The same run twice is no repeat: it says nothing of the scatter.
function data = onceEach (data)
  Z = data.Z;
  none = isnan (Z);
  Z(none) = 0;
  whole = [data.X, data.E, data.replicate, Z, none + isna(data.Z)];
  [~, first] = unique (whole, 'rows', 'first');
  first = sort (first);
  for name = fieldnames (data)'
    data.(name{1}) = data.(name{1})(first, :);
  end
end

% GONE: struct of the fields out, neverRun and lacking of the problem.
function [problem, kept, gone] = withoutDeadBenches (problem, data, few)
  isThere = any (isfinite (data.Z), 1);
  % of a change what was never measured in the new state is not run, and not missed
  isWanted = isempty (problem.reference) | ...
             ismember (problem.bench, problem.bench(isfinite (problem.value)));
  dead = setdiff (problem.bench(isWanted), problem.bench(isThere));
  gone.out = problem.benchNames(dead);
  wasRun = problem.bench(~all (isna (data.Z), 1));
  gone.neverRun = problem.benchNames(setdiff (dead, wasRun));
  isLacking = tooOftenLacking (data.Z, problem.bench);
  gone.lacking = problem.targetNames(isLacking);
  kept = find (~ismember (problem.bench, dead) & ~isLacking & (isWanted | ~few));
  left = intersect (problem.used, kept);
  if isempty (left) && isequal (gone.neverRun, gone.out)
    error ('DEcalioc:enterRuns:noRuns', ...
           ['enterRuns: at least one finished run of %s is needed, but no ' ...
            'run was made: raise Input.maxNewRuns.'], strjoin (gone.out, ', '));
  elseif isempty (left)
    error ('DEcalioc:enterRuns:runFailed', ...
           ['enterRuns: no run of %s gave a result, and no measured target ' ...
            'is left. Look at the failed runs.'], strjoin ([gone.out, gone.lacking], ', '));
  end
  if numel (kept) < numel (isWanted)
    problem = newProblem (ofTargets (problem, kept));
  end
end

function yes = tooOftenLacking (Z, bench)
  yes = false (size (bench));
  for t = 1:columns (Z)
    hasOther = any (isfinite (Z(:, bench == bench(t))), 2);
    lacks = hasOther & isnan (Z(:, t)) & ~isna (Z(:, t));
    yes(t) = sum (lacks) >= max (3, sum (hasOther) / 3);
  end
end

% Results of each target without an effect, and how many it needs: what the trend of
% the surrogates needs, and one run more.
function [there, needed] = neutralRuns (problem, data, options)
  p = columns (problem.limits);
  terms = struct ('choose', 1, 'constant', 1, 'affine', p + 1, ...
                  'quadratic', (p + 1) * (p + 2) / 2);
  needed = terms.(options.trend) + 1;
  phi = strengthOfValues (problem.effects, data.E);
  isBase = all (abs (phi) < 1e-9, 2);
  there = sum (isfinite (data.Z(isBase, :)), 1);
end

function checkEnough (problem, there, needed)
  few = find (there < needed, 1);
  if ~isempty (few)
    error ('DEcalioc:enterRuns:runFailed', ...
           ['enterRuns: %s has %d finite results of runs with all effects ' ...
            'neutral, needs %d or more. Run or import more of them, or ' ...
            'take the target out.'], problem.targetNames{few}, ...
           there(few), needed);
  end
end

function unit = unitsOf (problem, Z)
  span = max (Z, [], 1) - min (Z, [], 1);
  sizes = [problem.sd; abs(problem.value); span; max(abs (Z), [], 1)];
  sizes(end + 1, :) = 1;
  sizes(~(sizes > 0 & isfinite (sizes))) = 0;
  [~, first] = max (sizes > 0, [], 1);
  size_ = sizes(sub2ind (size (sizes), first, 1:columns (sizes)));
  unit = 2.^round (log2 (size_));
end

%!shared given, data
%! given = struct ('value', [1e-9, 2, 3e12], 'sd', [3e-11, 0, 1e11], ...
%!                 'limits', [0; 1], 'bench', [1, 1, 2]);
%! X = (1:6)' / 6;
%! data = struct ('X', X, 'E', zeros (6, 0), 'replicate', ones (6, 1), ...
%!                'Z', X .* [1e-9, 1, 1e12]);
%!test
%! [p, d] = enterRuns (newProblem (given), data, gapOptions ([]));
%! assert (p.sd(1) > 0.7 && p.sd(1) < 1.42);
%! assert (p.value, given.value ./ p.unit);
%! assert (d.Z .* p.unit, data.Z);
%! assert (p.out, cell (1, 0));
%!test
%! % no run of a bench gave a result: the other is diagnosed
%! data.Z(:, 3) = NaN;
%! [p, d] = enterRuns (newProblem (given), data, gapOptions ([]));
%! assert (p.out, {'bench2'});
%! assert (p.neverRun, cell (1, 0));
%! assert (p.kept, [1, 2]);
%! assert (p.used, [1, 2]);
%! assert (columns (d.Z), 2);
%! data.Z(:, 3) = NA;
%! p = enterRuns (newProblem (given), data, gapOptions ([]));
%! assert ({p.out, p.neverRun}, {{'bench2'}, {'bench2'}});
%!test
%! % two of six lack it, then three: out, with its name
%! some = setfield (data, 'Z', data.X .* [1e-9, 1, 1e12]);
%! some.Z(1:2, 1) = NaN;
%! p = enterRuns (newProblem (given), some, gapOptions ([]));
%! assert ({p.lacking, p.kept}, {cell(1, 0), 1:3});
%! some.Z(3, 1) = NaN;
%! [p, d] = enterRuns (newProblem (given), some, gapOptions ([]));
%! assert ({p.lacking, p.kept, columns(d.Z)}, {{'t1'}, [2, 3], 2});
%!test
%! % of a change: what the new state was not measured on is not missed, however few
%! % its runs; with enough of them it stays
%! change = newProblem (setfield (given, 'value', [1e-9, 2, NaN]));
%! change.reference = struct ('value', given.value, 'sd', given.sd);
%! for n = [0, 1, 6]
%!   data.Z = data.X .* [1e-9, 1, 1e12];
%!   data.Z(1:6 - n, 3) = NA;
%!   p = enterRuns (change, data, gapOptions ([]));
%!   assert ({p.out, p.neverRun, numel(p.kept)}, {cell(1, 0), cell(1, 0), 2 + (n > 1)});
%! end
%!test
%! % a run that is there twice counts once, a repeat does not
%! data.Z(4, 3) = NaN;
%! more = structfun (@(A) A([1:6, 4, 2], :), data, 'UniformOutput', false);
%! more.Z(8, 1) = 2 * more.Z(8, 1);
%! [~, d] = enterRuns (newProblem (given), more, gapOptions ([]));
%! assert (d.X, data.X([1:6, 2]));
%!test
%! % what is no table of runs
%! wrong = {'Z', @(Z) NaN (6, 3), 'gave a result'; ...
%!          'Z', @(Z) NA (6, 3), 'run was made: raise Input.maxNewRuns'; ...
%!          'Z', @(Z) [NaN(5, 3); Z(6, :)], 'needs'; ...
%!          'Z', @(Z) setfield(Z, {2, 2}, Inf), 'gives Inf for t2'; ...
%!          'X', @(X) setfield(X, {2}, NaN), 'run 2 has a parameter'; ...
%!          'Z', @(Z) Z', 'DATA.Z must be 6 x 3'}';
%! problem = newProblem (given);
%! for one = wrong
%!   bad = setfield (data, one{1}, one{2} (data.(one{1})));
%!   fail ('enterRuns (problem, bad, gapOptions ([]));', one{3});
%! end

% SPDX-License-Identifier: GPL-3.0-only
