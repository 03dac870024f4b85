% FIRSTLINE  What has changed, before any cause: in the unit of the measurement.
%
% CALL: TEXT = firstLine (GAP)
%
%   GAP   decoded gap/gap.json
%   TEXT  'Changed: slope 4.47 deg steeper (31.33 to 35.8), 6.2 times the noise.'; ''
%         for a gap, which is no change
%
% The three largest changes over their noise are said, the points of a curve as
% one: in shares of the reference, angles in their unit. What was measured as a
% logarithm is said as what it stands for: 83 % less, not 1.76 less. Noise: that of both
% measurements (changeOfReadings), as in the table Before and after; an amount ends where
% it begins.

function text = firstLine (gap)
  targets = jsonList (gap, {'reference', 'targets'});
  text = '';
  if isempty (targets)
    return
  end
  isOff = cellfun (@(T) isChanged (T, gap), targets);
  times = cellfun (@timesNoise, targets);
  code = 'some';
  said = isOff;
  if ~any (isOff)
    [~, top] = max (times);
    [said(top), code] = deal (true, 'none');
    if times(top) >= 2                   % more than its noise, as often by chance
      code = 'unsure';
    elseif times(top) < 0.05             % of a copy of the reference nothing is the most
      code = 'nothing';
    end
    if any (jsonAt (gap, {'which', 'p'}) < gap.thresholds.level)
      [said, code] = deal (said | alongCurve (targets, top, times), 'together');
    end
  end
  entries = entriesOf (targets, said, times);
  values = struct ('n', sum (isOff), 'of', numel (targets), ...
                   'list', strjoin (entries(1:min (3, end)), '; '));
  if numel (targets) == 1 && any (isOff)
    code = 'one';
  elseif numel (entries) > 3
    code = 'many';
  end
  text = sentence (['change.', code], values);
end

function yes = isChanged (T, gap)
  where = jsonList (gap, {'where', 'targets'});
  same = cellfun (@(w) strcmp (w.name, T.name) && strcmp (w.model, T.model), where);
  yes = any (cellfun (@(w) any (jsonAt (w, {'p'}) < gap.thresholds.level), where(same)));
end

% The places of the curve of target TOP that differ by more than one noise.
function is = alongCurve (targets, top, times)
  curves = cellfun (@curveOf, targets, 'UniformOutput', false);
  is = strcmp (curves, curves{top}) & ~isempty (curves{top}) & times >= 1;
end

function x = timesNoise (T)
  x = abs (T.measured - T.reference) / jsonNumber (T, {'sd'});
end

% The largest first; of a curve as large as its largest point.
function texts = entriesOf (targets, said, times)
  curves = cellfun (@curveOf, targets, 'UniformOutput', false);
  texts = {};
  [~, order] = sort (-times);
  for t = order(said(order))
    own = strcmp (curves, curves{t}) & ~isempty (curves{t});
    if sum (own) < 3
      texts{end + 1} = pointText (targets{t}, times(t));
    elseif t == order(find (own(order) & said(order), 1))
      texts{end + 1} = curveText (curves{t}, targets(own & said), sum (own), times(t));
    end
  end
end

function name = curveOf (T)
  name = char (jsonAt (T, {'series'}));
end

function text = pointText (T, times)
  factor = jsonNumber (T, {'shown', 'factor'}, 1);
  values = valuesOf (T, times, T.measured > T.reference);
  [from, to, sd] = deal (T.reference / factor, T.measured / factor, ...
                         jsonNumber (T, {'sd'}) / factor);
  digits = @(kind, x, sd) regexprep (plainNumber (x, regexprep (noiseKind (kind, x, sd), ...
                                                                ' 0$', ' 1')), '^\+', '');
  % one digit more, or their difference would be another one
  values.from = digits ('plain', from, sd / 10);
  values.to = digits ('plain', to, sd / 10);
  shown = str2double (values.to) - str2double (values.from);
  if isLog (T)
    [values.amount, values.way] = ratioText (exp (to - from), values.way);
    values.from = ['ln ', values.from];
  else
    unit = regexprep (char (jsonAt (T, {'shown', 'unit'})), '^-$', '');
    if ~(abs (shown - (to - from)) < 0.1 * sd)
      shown = to - from;
    end
    values.amount = strtrim ([digits('change', abs (shown), sd), ' ', unit]);
  end
  text = sentence ('change.point', values);
end

function yes = isLog (T)
  yes = strncmp (char (jsonAt (T, {'kind'})), 'log', 3);
end

% '83 %' 'less', '3.1 times' 'what it was', of a ratio.
function [amount, way] = ratioText (ratio, way)
  amount = [twoDigits(100 * abs (ratio - 1)), ' %'];
  if ratio >= 2
    amount = [twoDigits(ratio), ' times'];
  elseif ratio < 0.01
    amount = ['1/', twoDigits(1 / ratio), ' of'];
  end
  if ratio >= 2 || ratio < 0.01
    way = sentence ('way.timesMore');
  end
end

function share = relativeChange (T)
  share = (T.measured - T.reference) / abs (T.reference);
  if isLog (T)
    share = exp (T.measured - T.reference) - 1;
  end
end

% Of a curve whose points are measured under names of their own, these.
function name = nameOf (name, changed)
  names = cellfun (@(T) T.name, changed, 'UniformOutput', false);
  if numel (names) > 1 && ~any (cellfun (@(text) any (text == '@'), names))
    names = sort (names);
    name = [names{1}, ' to ', names{end}];
  end
end

% Where all points go one way, by what share, of an angle by what; else how many go
% which way.
function text = curveText (name, changed, many, times)
  [share, unit] = deal (100 * cellfun (@relativeChange, changed), '%');
  if strcmp (kindOf (changed{1}), 'angle') && ~isLog (changed{1})
    unit = jsonAt (changed{1}, {'shown', 'unit'});
    share = cellfun (@(T) T.measured - T.reference, changed) / ...
            jsonNumber (changed{1}, {'shown', 'factor'}, 1);
  end
  values = valuesOf (changed{1}, times, sum (share) > 0);
  [values.name, values.n, values.of, values.unit] = deal (nameOf (name, changed), ...
                                                          numel (changed), many, unit);
  code = 'curve';
  if all (share > 0) || all (share < 0)
    code = 'curveOneWay';
    if numel (share) == 1
      code = 'curveOnePlace';
    end
    share = sort (abs (share));
    said = @(x) merge (x >= 10, sprintf ('%.0f', x), sprintf ('%.2g', x));
    [values.least, values.share, values.most] = deal (said (share(1)), ...
                                                      said (median (share)), ...
                                                      said (share(end)));
  end
  text = sentence (['change.', code], values);
end

% 'steeper' of an angle, 'less' of a mass: by the kind of the result.
function values = valuesOf (T, times, isMore)
  kind = kindOf (T);
  if ~any (strcmp (kind, {'angle', 'mass', 'rate', 'time', 'height', 'density'}))
    kind = 'other';
  end
  way = ['way.', merge(isMore, 'more', 'less'), '.', kind];
  values = struct ('name', T.name, 'way', sentence (way), ...
                   'times', timesText (times));
end

function kind = kindOf (T)
  kind = regexprep (char (jsonAt (T, {'kind'})), '^(angle|coneAngle).*', 'angle');
end

function text = timesText (x)
  form = '%.1f';
  if x >= 10
    form = '%.0f';
  elseif x >= 1
    form = '%.2g';
  end
  text = sprintf (form, x);
end

%!function gap = changed (n, names, series)
%!  % N results, all of the noise 0.5; each is 3 more than 30 at the reference
%!  gap.thresholds.level = 0.05;
%!  gap.reference.targets = struct ('model', 'Heap', 'name', names(1:n), 'kind', ...
%!    'angle', 'series', series, 'reference', 30, 'measured', 33, 'sd', 0.5, ...
%!    'shown', struct ('unit', 'deg', 'factor', 1));
%!  gap.where.targets = struct ('model', 'Heap', 'name', names(1:n), 'p', 0.01);
%!  gap = jsondecode (jsonencode (gap));
%!endfunction
%!shared names
%! names = {'a', 'b', 'c', 'd', 'e'};
%!assert (firstLine (struct ('reference', [])), '')
%!assert (firstLine (changed (1, names, '')), ...
%!        'Changed: a 3 deg steeper (30 to 33), 6 times the noise.')
%!test
%! % in the unit of the user; the three largest; one that is within noise
%! gap = changed (5, names, '');
%! gap.reference.targets(2).shown = struct ('unit', 'g', 'factor', 1e-3);
%! gap.reference.targets(2).kind = 'mass';
%! [gap.reference.targets(2).reference, gap.reference.targets(2).measured] = deal (0.03, 0.02);
%! gap.reference.targets(2).sd = 0.001;
%! gap.where.targets(1).p = 0.5;
%! text = firstLine (gap);
%! assert (! isempty (strfind (text, '4 of 5')), text);
%! assert (! isempty (strfind (text, 'b 10 g less (30 to 20), 10 times the noise')), text);
%! [gap.where.targets.p] = deal (0.5);
%! text = firstLine (gap);
%! assert (! isempty (strfind (text, 'b 10 g less')) && isempty (strfind (text, 'c 3')), text);
%! % 10 times the noise is not within noise
%! assert (strncmp (text, 'No result surely changed; most of all b', 39), text);
%!test
%! gap = changed (2, names, '');
%! [gap.where.targets.p] = deal (0.9);
%! [gap.reference.targets.measured] = deal (30);
%! gap.which.p = 0.9;
%! assert (firstLine (gap), 'No result changed by more than noise.');
%!test
%! % to the noise; a logarithm as what it stands for
%! gap = changed (1, names, '');
%! [gap.reference.targets.reference, gap.reference.targets.measured] = deal (19.0933, 19.5467);
%! gap.reference.targets.sd = 2.06;
%! said = @(gap) regexprep (firstLine (gap), ', [\d.]+ times the noise.$', '');
%! assert (said (gap), 'Changed: a 0.5 deg steeper (19.09 to 19.55)');
%! [gap.reference.targets.reference, gap.reference.targets.measured] = deal (-0.28, 0.09398);
%! gap.reference.targets.sd = 0.118;
%! assert (said (gap), 'Changed: a 0.37 deg steeper (-0.28 to 0.094)');
%! gap.reference.targets.kind = 'logMass';
%! [gap.reference.targets.reference, gap.reference.targets.measured] = deal (-1.27, -3.03);
%! assert (said (gap), 'Changed: a 83 % less (ln -1.27 to -3.03)');
%! gap.reference.targets.measured = -7.4;
%! assert (said (gap), 'Changed: a 1/459 of what it was (ln -1.27 to -7.4)');
%! gap.reference.targets.measured = -0.13;
%! assert (said (gap), 'Changed: a 3.1 times what it was (ln -1.27 to -0.13)');
%! gap.reference.targets.measured = 3.6;
%! assert (said (gap), 'Changed: a 130 times what it was (ln -1.27 to 3.6)');
%! gap = changed (4, names, 'discharge');
%! [gap.reference.targets.kind] = deal ('logRatio');
%! [gap.reference.targets.measured] = deal (30 + log (1.5));
%! assert (! isempty (strfind (firstLine (gap), 'a to d 50 % more at 4 of 4 places')));
%!test
%! % a curve is one thing, said in shares; an angle in its unit
%! gap = changed (4, names, 'discharge');
%! [gap.reference.targets.measured] = deal (10, 12, 15, 15);
%! text = firstLine (gap);
%! assert (! isempty (strfind (text, 'a to d 16 deg flatter at 4 of 4 places (15 to 20 deg)')), ...
%!         text);
%! % no place alone, but all together
%! together = gap;
%! [together.where.targets.p] = deal (0.2);
%! together.which.p = 0.01;
%! text = firstLine (together);
%! assert (! isempty (strfind (text, 'at 4 of 4 places')), text);
%! together.which.p = 0.3;
%! assert (! isempty (strfind (firstLine (together), 'at 1 of 4 places, ')));
%! gap.reference.targets(1).measured = 50;
%! assert (! isempty (strfind (firstLine (gap), 'a to d at 4 of 4 places')));

% SPDX-License-Identifier: GPL-3.0-only
