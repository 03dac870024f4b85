% GROUPMEASURED  Makes targets of the lines of measured.csv.
%
% CALL: [GROUPS, FAULTS, CONDITIONS] = groupMeasured (LIST, MODELS, FURTHER)
%
%   LIST      struct array of readMeasured
%   MODELS    cell of the names of the models
%   FURTHER   cell, those of further models (filledTests; default none)
%   GROUPS    1 x T struct, sorted by model, else in the order of the table:
%             line, file (first), model, name (of the target), result (name of
%             the result or curve), series, at, unit, given (unit of the
%             table, see checkUnits), value, sd, trials,
%             scatter (logical: sd holds the scatter of the trials), role, tol,
%             isAbsolute, curve (number of its series, 0: none), each
%             (1 x n, the trials), changed (1 x C struct value, sd, trials,
%             scatter, each other condition; value NaN: not measured)
%   FAULTS    1 x p faults, see checkFault; reasons: measuredRepeats
%             measuredCondition
%   CONDITIONS  1 x C cell, names of the conditions but for the reference, of
%             which all the other fields are; none where LIST has no conditions
%
% Lines with the same model, name, series and at are repeated trials. Their
% value is the mean; its standard uncertainty is t s / sqrt (n), s the standard
% deviation of the n lines and t the 84 % quantile of Student's distribution
% with n - 1 degrees of freedom (GUM, type A; few trials know their own scatter
% badly), joined with the sd of the lines, which is what they have in common.
% The value of a point of a curve is named <name or series>@<at>, unless the
% name stands in one place only; see distinctNames.

function [groups, p, conditions] = groupMeasured (list, models, further)
  if nargin < 3
    further = {};
  end
  p = checkFault ();
  isOther = ~ismember ({list.condition}, {'', 'reference'});
  conditions = unique ({list(isOther).condition}, 'stable');
  others = cellfun (@(c) list(strcmp ({list.condition}, c)), conditions, ...
                    'UniformOutput', false);
  list = withPlaces (list(~isOther));
  trials = byQuantity (list);
  faults = cellfun (@checkAlike, trials, 'UniformOutput', false);
  p = [p, faults{:}];
  groups = cellfun (@oneTarget, trials);
  [groups, q] = withConditions (groups, unique (keysOf (list), 'stable'), ...
                                others);
  p = [p, q];
  [~, order] = sort ([groups.model]);
  groups = distinctNames (groups(order), models, further);
  series = arrayfun (@(g) sprintf ('%d|%s', g.model, g.series), groups, ...
                     'UniformOutput', false);
  [~, number] = ismember (series, unique (series, 'stable'));
  number = num2cell (number .* ~cellfun (@isempty, {groups.series}));
  [groups.curve] = number{:};
end

function keys = keysOf (list)
  keys = arrayfun (@(o) sprintf ('%d|%s|%s|%.12g', o.model, o.name, ...
                                 o.series, o.at), list(:)', ...
                   'UniformOutput', false);
end

% The lines of each quantity: 1 x n cell.
function parts = byQuantity (list)
  [~, first, number] = unique (keysOf (list), 'first');
  [~, order] = sort (first);
  rows = accumarray (number(:), 1:numel (list), [], @(k) {sort(k)});
  parts = cellfun (@(k) list(k), rows(order)', 'UniformOutput', false);
end

% Beside each line on how many places of its curve its name stands.
function list = withPlaces (list)
  names = arrayfun (@(o) sprintf ('%d|%s', o.model, o.name), list, ...
                    'UniformOutput', false);
  [~, ~, number] = unique (names);
  pairs = unique ([number(:), [list.at]'], 'rows');
  count = num2cell (accumarray (pairs(:, 1), 1)(number));
  [list.places] = count{:};
end

% The same quantities in the other conditions.
function [groups, p] = withConditions (groups, keys, others)
  p = checkFault ();
  none = struct ('value', NaN, 'sd', 0, 'trials', 1, 'scatter', false);
  [groups.changed] = deal (repmat (none, 1, numel (others)));
  for c = 1:numel (others)
    for trials = byQuantity (others{c})
      first = trials{1}(1);
      same = find (strcmp (keysOf (first), keys), 1);
      if isempty (same)
        where = sprintf ('%s, line %d', first.file, first.line);
        p(end + 1) = checkFault ('measuredCondition', where, ...
                                 'what was measured in the reference, too', ...
                                 [first.name, first.series], ...
                                 ['Add its value before the change, or ' ...
                                  'take the line out.']);
        continue
      end
      target = oneTarget (withPlaces (trials{1}));
      for name = fieldnames (none)'
        groups(same).changed(c).(name{1}) = target.(name{1});
      end
    end
  end
end

% What one trial says holds for all: it must not say two things.
function p = checkAlike (trials)
  p = checkFault ();
  if isscalar (trials)
    return
  end
  for field = {'role', 'tol', 'isAbsolute', 'unit'}
    given = trials(isGiven (trials, field{1}));
    for trial = given(2:end)
      if ~isequaln (trial.(field{1}), given(1).(field{1}))
        where = sprintf ('%s, line %d, %s', trial.file, trial.line, field{1});
        p(end + 1) = checkFault ('measuredRepeats', where, ...
                                 sprintf (['what line %d has: it is the ' ...
                                           'same quantity'], given(1).line), ...
                                 checkShow (trial.(field{1})), ...
                                 'Give it once, or alike in every trial.');
      end
    end
  end
end

function given = isGiven (trials, field)
  if strcmp (field, 'isAbsolute')
    field = 'tol';
  end
  given = ~arrayfun (@(o) isempty (o.(field)) || ...
                     any (isnan (double (o.(field)))), trials);
end

function value = firstOf (trials, field)
  if numel (trials) > 1
    trials = trials([find(isGiven (trials, field)), 1]);
  end
  value = trials(1).(field);
end

function g = oneTarget (trials)
  one = trials(1);
  g = struct ('line', one.line, 'file', one.file, 'model', one.model, ...
              'name', targetName (one), 'result', one.name, ...
              'series', one.series, 'at', one.at, ...
              'unit', firstOf (trials, 'unit'), ...
              'given', givenField (one, 'given', one.unit), 'value', NaN, ...
              'sd', max ([trials.sd]), 'trials', 1, 'scatter', false, ...
              'role', firstOf (trials, 'role'), ...
              'tol', firstOf (trials, 'tol'), ...
              'isAbsolute', firstOf (trials, 'isAbsolute'), 'curve', 0, ...
              'each', zeros (1, 0));
  if isempty (g.role)
    g.role = 'calibrate';
  end
  if isempty (g.result)
    g.result = g.series;
  end
  trials = trials(isfinite ([trials.value]));
  if isempty (trials)
    g.role = 'unmeasured';
    return
  end
  weight = [trials.repeats];
  weight(isnan (weight)) = 1;
  finite = min (weight, 1e6);
  value = [trials.value];
  g.each = value;
  g.value = value * finite' / sum (finite);
  g.trials = sum (weight);
  g.sd = mean ([trials.sd]);
  n = numel (trials);
  if n > 1
    s = sqrt (finite / mean (finite) * (value - g.value)'.^2 / (n - 1));
    g.sd = hypot (-studentQuantile (0.1587, n - 1) * s / sqrt (n), g.sd);
    g.scatter = s > 0;
    g.isAbsolute = g.isAbsolute || g.value == 0;
  end
end

function name = targetName (row)
  name = row.name;
  if isempty (row.series)
    return
  end
  if isempty (name)
    name = row.series;
  elseif row.places == 1
    return
  end
  name = sprintf ('%s@%.6g', name, row.at);
end

%!shared line
%! line = struct ('line', 2, 'model', 1, 'name', 'a', 'series', '', ...
%!                'unit', 'kg', 'at', NaN, 'value', 1, 'sd', 0, ...
%!                'repeats', NaN, 'role', 'calibrate', 'tol', 0.1, ...
%!                'isAbsolute', false, 'condition', '', 'file', 't.csv');
%!test
%! % three trials: t = 1.32 for two degrees of freedom
%! list = repmat (line, 1, 3);
%! [list.value] = deal (1, 2, 3);
%! [g, p] = groupMeasured (list, {'A', 'B'});
%! assert (isempty (p));
%! assert ([g.value, g.trials], [2, 3]);
%! assert (g.sd, 1.32 / sqrt (3), 2e-3);
%! assert (g.scatter);
%! [list.sd] = deal (0.5);
%! g = groupMeasured (list, {'A', 'B'});
%! assert (g.sd, hypot (1.32 / sqrt (3), 0.5), 2e-3);
%!test
%! % a mean that was typed in, and one that is not measured yet
%! list = [line, line];
%! list(1).repeats = 5;
%! list(2).name = 'b';
%! list(2).value = NaN;
%! g = groupMeasured (list, {'A', 'B'});
%! assert ([g.trials; g.scatter], [5, 1; 0, 0]);
%! assert ({g.role}, {'calibrate', 'unmeasured'});
%! assert ({g.name}, {'a', 'b'});
%!test
%! % points of a curve, and named results that form a series
%! list = repmat (line, 1, 4);
%! [list.series] = deal ('w');
%! [list.at] = deal (1, 2, 1, 2);
%! [list.name] = deal ('', '', 'r1', 'r2');
%! g = groupMeasured (list, {'A', 'B'});
%! assert ({g.name}, {'w@1', 'w@2', 'r1', 'r2'});
%! assert ({g.result}, {'w', 'w', 'r1', 'r2'});
%! assert ([g.curve], [1, 1, 1, 1]);
%!test
%! list = [line, line];
%! list(2).tol = 0.2;
%! [~, p] = groupMeasured (list, {'A', 'B'});
%! assert (p.id, 'DEcalioc:checkCase:measuredRepeats');
%! list(2).tol = NaN;
%! list(2).model = 0;
%! [g, p] = groupMeasured (list, {'A', 'B'});
%! assert (isempty (p));
%! assert ([g.model], [0, 1]);
%!test
%! % another condition stands beside the reference; a new quantity is a fault
%! list = repmat (line, 1, 4);
%! [list(2:4).condition] = deal ('moist');
%! [list.value] = deal (1, 2, 4, 7);
%! list(4).name = 'b';
%! [g, p, conditions] = groupMeasured (list, {'A'});
%! assert (conditions, {'moist'});
%! assert ({g.value, g.changed.value, g.changed.trials}, {1, 3, 2});
%! assert (p.id, 'DEcalioc:checkCase:measuredCondition');
