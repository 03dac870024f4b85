% GROUPMEASURED  Makes targets of the lines of measured.csv.
%
% CALL: [GROUPS, FAULTS, CONDITIONS, SESSIONS] = ...
%         groupMeasured (LIST, MODELS, FURTHER)
%
%   LIST      struct array of readMeasured
%   MODELS    cell of the names of the models
%   FURTHER   cell, those of further models (filledMeasurements; default none)
%   GROUPS    1 x T struct, sorted by model, else in the order of the table:
%             line, file (first), model, name (of the target), result (name of
%             the result or curve), series, at, unit, given (unit of the
%             table, see checkUnits), value, sd, trials,
%             scatter (logical: sd holds the scatter of the trials), role, tol,
%             isAbsolute, each (1 x n, the trials), shared (part of sd that the
%             sessions make), days and the freedoms of varianceComponents,
%             sessions (1 x n cell, of the trials), changed (1 x C struct value, sd,
%             trials, scatter, shared, days, freedoms, scatterRatio, scatterP, swept,
%             each, sessions of each other condition; value NaN: not measured)
%   FAULTS    1 x p faults, see checkFault; reasons: measuredRepeats
%             measuredCondition
%   CONDITIONS  1 x C cell, names of the conditions but for the reference, of
%             which all the other fields are; none where LIST has no conditions
%   SESSIONS  struct: given (logical: LIST has sessions), ratio (standard deviation
%             between sessions over that of a trial within one, of levels; 0 where
%             none are given), df (how many contrasts between sessions told it; 0:
%             it is what other rigs show), known (logical: measured.csv says what
%             sessions bring), drifts (1 x D struct of what drifts within a session,
%             []: session, name, slope (per order, in its unit, of a curve a share),
%             p, oneWay: cell of conditions, see withoutDrift, isAgain: logical, a
%             change has no order that the reference has not)
%
% Lines with the same model, name, series and at are repeated trials. What they
% say together, and how well, is that of varianceComponents; sd is the 68 %
% half-width, joined with the sd that trials have in common. Where their sd
% differ, each counts by its own (measuredTarget).
% The value of a point of a curve is named <name or series>@<at>, unless the
% name stands in one place only.

function [groups, p, conditions, sessions] = groupMeasured (list, models, ...
                                                            further)
  if nargin < 3
    further = {};
  end
  p = checkFault ();
  isOther = ~ismember ({list.condition}, {'', 'reference'});
  conditions = unique ({list(isOther).condition}, 'stable');
  [list, means, sessions] = withMeans (list);
  others = cellfun (@(c) list(strcmp ({list.condition}, c)), conditions, ...
                    'UniformOutput', false);
  list = withPlaces (list(~isOther));
  trials = byQuantity (list);
  [groups, faults] = cellfun (@(t) measuredTarget (t, means), trials, ...
                              'UniformOutput', false);
  [groups, p] = deal ([groups{:}], [p, faults{:}]);
  [groups, q] = withConditions (groups, unique (keysOf (list), 'stable'), ...
                                others, means);
  p = [p, q];
  [~, order] = sort ([groups.model]);
  groups = distinctNames (groups(order), models, further);
end

% Beside each line the number of its mean.
function [list, means, sessions] = withMeans (list)
  if ~any (isfinite ([list.value]))      % nothing is measured yet
    means = [];
    sessions = struct ('given', false, 'ratio', 0, 'df', 0);
    return
  end
  [lines, quantities, number, names, at] = readingLines (list, keysOf (list));
  before = lines.value;
  [lines, drifts] = withoutDrift (lines, quantities);
  drift = zeros (size (list));
  taken = before - lines.value;
  drift(at > 0) = taken(at(at > 0));
  drift = num2cell (drift);
  [list.drift] = drift{:};
  [means, ratio] = varianceComponents (lines, quantities);
  means = withDrifts (means, lines, quantities, drifts);
  number = num2cell (number);
  [list.mean] = number{:};
  drifts = arrayfun (@(one) saidDrift (one, list, [{''}, names]), drifts, ...
                     'UniformOutput', false);
  isKnown = all (isfinite ([quantities.sessionSd])) || all (isfinite (lines.variance));
  sessions = struct ('given', ~isempty (names) && ~isKnown, 'known', isKnown, ...
                     'ratio', 0, 'df', 0, 'drifts', [drifts{:}]);
  if sessions.given
    [sessions.ratio, sessions.df] = deal (ratio(1).value, ratio(1).df);
  end
end

function said = saidDrift (drift, list, names)
  first = list(find (ismember ([list.mean], drift.means), 1));
  name = first.name;
  if ~isempty (first.series)
    name = first.series;
  end
  conditions = {list(ismember ([list.mean], drift.oneWay)).condition};
  % no name of a user holds a bar
  session = regexprep (names{1 + drift.session}, '^\|', '');
  own = list(ismember ([list.mean], drift.means) & strcmp ({list.session}, session));
  isBefore = ismember ({own.condition}, {'', 'reference'});
  isAgain = ~isempty (session) && ~all (isBefore) && ...
            all (ismember ([own(~isBefore).order], [own(isBefore).order]));
  said = struct ('session', session, 'name', name, 'slope', ...
                 drift.slope, 'p', drift.p, 'oneWay', ...
                 {unique(conditions, 'stable')}, 'isAgain', isAgain);
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
function [groups, p] = withConditions (groups, keys, others, means)
  p = checkFault ();
  none = struct ('value', NaN, 'sd', 0, 'trials', 1, 'scatter', false, ...
                 'shared', 0, 'days', [], 'freedom', Inf, 'commonFreedom', Inf, ...
                 'sessionFreedom', Inf, 'scatterRatio', NaN, 'scatterP', NaN, ...
                 'swept', false, 'each', zeros (1, 0), 'sessions', {{}});
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
      target = measuredTarget (withPlaces (trials{1}), means);
      if isfinite (target.value) && ~isfinite (groups(same).value)
        where = sprintf ('%s, line %d, value', groups(same).file, groups(same).line);
        p(end + 1) = checkFault ('measuredCondition', where, ...
                                 'a value of the reference, as a condition has one', ...
                                 'nothing', ['Add its value before the change, or take ' ...
                                             'both lines out.']);
      end
      given = setdiff ({trials{1}.role}, {''});
      if ~all (strcmp (given, groups(same).role))
        p(end + 1) = checkFault ('measuredCondition', ...
                                 sprintf ('%s, line %d, role', first.file, first.line), ...
                                 ['the role of the reference, ', groups(same).role], ...
                                 given{1}, 'Give it once, or alike in every line.');
      end
      for name = fieldnames (none)'
        groups(same).changed(c).(name{1}) = target.(name{1});
      end
    end
  end
end

% Where several models have a target of one name, it is <model>_<name>: a name is a column of
% runs.csv, so further models leave those of the others as they are.
function groups = distinctNames (groups, models, further)
  names = {groups.name};
  of = [groups.model];
  if all (of == of(1))
    return
  end
  isLate = of > 0;
  isLate(isLate) = ismember (models(of(isLate)), further);
  for k = find (of > 0)
    if any (strcmp (names, names{k}) & of ~= of(k) & isLate <= isLate(k))
      groups(k).name = [models{of(k)}, '_', names{k}];
    end
  end
end

%!shared line
%! line = struct ('line', 2, 'model', 1, 'name', 'a', 'series', '', ...
%!                'unit', 'kg', 'at', NaN, 'value', 1, 'sd', 0, ...
%!                'repeats', NaN, 'role', 'calibrate', 'tol', 0.1, ...
%!                'isAbsolute', false, 'condition', '', 'file', 't.csv', 'session', '');
%!test
%! % three trials: t = 1.32 for two degrees of freedom
%! list = repmat (line, 1, 3);
%! [list.value] = deal (1, 2, 3);
%! [g, p] = groupMeasured (list, {'A', 'B'});
%! assert (isempty (p));
%! assert ([g.value, g.trials], [2, 3]);
%! assert (g.sd, 1.32 / sqrt (3), 0.02);
%! assert (g.scatter);
%! [list.sd] = deal (0.5);
%! g = groupMeasured (list, {'A', 'B'});
%! assert (g.sd, hypot (1.32 / sqrt (3), 0.5), 0.02);
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
%!test
%! % two sessions in each of two conditions; one condition shares them
%! list = repmat (line, 1, 12);
%! [list.condition] = deal ('reference', 'reference', 'reference', ...
%!                          'reference', 'a', 'a', 'a', 'a', 'b', 'b', 'b', 'b');
%! [list.session] = deal ('mon', 'mon', 'tue', 'tue', 'mon', 'mon', 'tue', ...
%!                        'tue', 'wed', 'wed', 'wed', 'wed');
%! values = num2cell ([1, 2, 5, 6, 3, 4, 7, 8, 1, 2, 1, 2]);
%! [list.value] = values{:};
%! [g, ~, ~, sessions] = groupMeasured (list, {'A'});
%! % days that both share tell once
%! assert (sessions.df, 1);
%! assert ({g.value, g.sessions}, {3.5, {'mon', 'mon', 'tue', 'tue'}}, 1e-12);
%! assert (g.shared > 0.8 * g.sd && g.shared < g.sd);
%! assert (isempty (sessions.drifts));
%! % of the same days the difference is free
%! assert (g.days, g.changed(1).days, 1e-12);
%! assert (g.days * g.changed(2).days', 0);
%! assert (g.scatter);
%! assert (g.changed(2).sd > g.changed(1).sd);
%!test
%! % a drift of the day: states in turn are told apart as without it, one way not
%! list = repmat (line, 1, 16);
%! [list.session] = deal ('mon');
%! [list(9:16).condition] = deal ('moist');
%! e = 0.1 * [1, -1, 0, 2, -2, 1, -1, 0];
%! turns = {1:2:15, 2:2:16; 1:8, 9:16};
%! for k = 1:2
%!   order = num2cell ([turns{k, :}]);
%!   [list.order] = order{:};
%!   values = num2cell ([10 + e, 10.5 + e] + 0.3 * [order{:}]);
%!   [list.value] = values{:};
%!   [g(k), ~, ~, sessions] = groupMeasured (list, {'A'});
%!   drift = sessions.drifts;
%!   assert ({drift.session, drift.name}, {'mon', 'a'});
%!   assert (drift.slope, 0.3, 0.02);
%!   sd(k) = sdOfChange (g(k), g(k).changed);
%!   assert (g(k).changed.value - g(k).value, 0.5, 0.2);
%! end
%! assert ({drift.oneWay, drift.isAgain}, {{'moist'}, false});
%! assert ({g(1).changed.swept, g(2).changed.swept}, {false, true});
%! assert (sd(1), 0.06, 0.03);
%! assert (sd(2), 0.3 * 8, 0.1);
%! % each state numbered from 1
%! order = num2cell ([1:8, 1:8]);
%! [list.order] = order{:};
%! [~, ~, ~, sessions] = groupMeasured (list, {'A'});
%! assert (sessions.drifts.isAgain);
%!test
%! % names that no two models share
%! list = repmat (line, 1, 3);
%! [list.name] = deal ('a', 'b', 'a');
%! list(3).model = 2;
%! names = @(list, further) {groupMeasured(list, {'M', 'N'}, further).name};
%! assert (names (list, {}), {'M_a', 'b', 'N_a'});
%! assert (names (list, {'N'}), {'a', 'b', 'N_a'});
%! assert (names (list(1:2), {}), {'a', 'b'});

%!function g = read (text)
%!  file = tempname ();
%!  writeAtomic (file, ["condition,name,value,sd,repeats,session,sessionSd,tol\n", text]);
%!  g = groupMeasured (readMeasured (file, {'A'}), {'A'});
%!endfunction
%!test
%! % readings that are alike: their value stays, and so does a stated sd
%! g = read ([repmat("reference,a,735,,,,,2%\n", 1, 4), repmat("now,a,705,,,,,\n", 1, 4)]);
%! assert ([g.value, g.changed.value, g.sd], [735, 705, 0], 1e-9);
%! g = read ([repmat("reference,a,31,0.5,,,,2%\n", 1, 2), repmat("now,a,32,0.5,,,,\n", 1, 2)]);
%! assert ([g.sd, g.changed.sd], [0.5, 0.5], 1e-9);
%! g = read ([repmat("reference,a,31,,,,,2%\n", 1, 3), "now,a,33,0.7,3,,,\n"]);
%! assert (g.changed.sd, 0.7, 1e-9);
%! g = read ("reference,a,31,0.4,,,,2%\nreference,a,31,0.5,,,,\nnow,a,33,0.7,,,,\n");
%! assert ([g.sd, g.changed.sd], [1 / sqrt(1 / 0.16 + 1 / 0.25), 0.7], 1e-9);
%! % over several days lines weigh by their own sd, too
%! file = tempname ();
%! writeAtomic (file, ["name,value,sd,session,tol\n", "a,1.05,0.1,mon,2%\na,4,5,mon,\n", ...
%!                     "a,0.95,0.1,tue,\na,-3.5,5,tue,\n"]);
%! g = groupMeasured (readMeasured (file, {'A'}), {'A'});
%! assert (g.value, 1, 0.01);
%! assert (g.sd > 0.05 && g.sd < 0.3, num2str (g.sd));
%! % one line a day: their sd are what is known of a trial, by its repeats
%! writeAtomic (file, ["name,value,sd,repeats,session,tol\n", "a,1,0.1,3,mon,2%\n", ...
%!                     "a,1.1,0.1,3,tue,\na,1.4,0.5,3,wed,\n"]);
%! g = groupMeasured (readMeasured (file, {'A'}), {'A'});
%! assert (g.freedom, 6, 0.5);
%! % of a block the one line counts as well as it says, once
%! file = tempname ();
%! writeAtomic (file, ["name,value,sd,block,tol\n", "a,31,0.5,x,2%\na,32,,x,\n"]);
%! g = groupMeasured (readMeasured (file, {'A'}), {'A'});
%! assert ([g.value, g.sd], [31.5, 0.5], 1e-4);
%!test
%! % a line that does not say of how many trials it is takes nothing from the others
%! g = read ("reference,a,31.2,0.5,3,,,2%\nnow,a,33.9,0.5,,,,\n");
%! [~, freedom] = sdOfChange (g, g.changed);
%! assert (freedom < 4);
%! pair = "reference,a,31.2,0.5,3,,,2%\nnow,a,33.9,0.5,3,,,\n";
%! [g, both] = deal (read ([pair, "other,a,34,0.5,,,,\n"]), read (pair));
%! assert (sdOfChange (g, g.changed(1)), sdOfChange (both, both.changed), 1e-6);
%!test
%! % beside lines that scatter a mean of three is three trials: Student's test
%! g = read (["reference,a,31.2,0.5,3,,,2%\n", ...
%!            "now,a,34.2,,,,,\nnow,a,34.9,,,,,\nnow,a,36.2,,,,,\n"]);
%! [sd, freedom] = sdOfChange (g, g.changed);
%! pooled = sqrt ((2 * 3 * 0.5^2 + 2 * var ([34.2, 34.9, 36.2])) / 4 * 2 / 3);
%! assert (sd / studentFactor (freedom), pooled, 0.15 * pooled);
%! assert (freedom > 3);
%!test
%! % what a session brings is in each state, though no session has a name
%! g = read ("reference,a,31,0.5,3,,2,2%\nnow,a,33.9,0.5,3,,2,\n");
%! assert (sdOfChange (g, g.changed) > sqrt (8));
%! % and beside lines whose sd differ
%! g = read ("reference,a,31,0.5,,mon,2,2%\nreference,a,31.2,0.4,,mon,,\n");
%! assert (g.sd, hypot (1 / sqrt (1 / 0.25 + 1 / 0.16), 2), 1e-6);
%!test
%! % a condition without its reference
%! file = tempname ();
%! writeAtomic (file, "condition,name,value\nreference,a,\nnow,a,3\n");
%! [~, p] = groupMeasured (readMeasured (file, {'A'}), {'A'});
%! assert (p.id, 'DEcalioc:checkCase:measuredCondition');
%! % and one of another role
%! writeAtomic (file, ["condition,name,value,role\nreference,a,2,holdout\n", ...
%!                     "now,a,3,\nthen,a,4,calibrate\n"]);
%! [~, p] = groupMeasured (readMeasured (file, {'A'}), {'A'});
%! assert (p.id, 'DEcalioc:checkCase:measuredCondition');

% SPDX-License-Identifier: GPL-3.0-only
