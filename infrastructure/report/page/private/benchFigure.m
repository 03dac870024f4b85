% BENCHFIGURE  Figure of one bench: each target against what it can reach.
%
% CALL: [F, KEY] = benchFigure (PAGE, MODEL)
%
%   PAGE   see pageData
%   MODEL  name of the bench (text)
%   F      see newFigure; [] where nothing of the bench was measured
%   KEY    what its symbols mean, see htmlKey
%
% One row a target (of a curve its worst point): measured at 0, in units of what
% is allowed, else of its noise. The band of what the box can reach shows why a
% target is missed.

function [f, key] = benchFigure (page, model)
  key = {};
  misses = page.verdict.misses;
  misses = misses(strcmp ({misses.model}, model) & ...
                  ~strcmp ({misses.role}, 'unmeasured'));
  list = [];
  for m = fliplr (misses)
    list = [list, oneRow(page, m)];
  end
  f = [];
  if isempty (list)
    return
  end
  key = keyOf (page, list(1).isAllowed, any (isfinite (vertcat (list.reach)(:))));
  key = key(~strcmp (key(:, 1), 'dots') | ~isempty ([list.trials]), :);
  n = numel (list);
  of = merge (list(1).isAllowed, 'its tolerance', 'the noise');
  values = [[list.now], [list.with], [list.trials], -1, 1];
  most = max (abs (values(isfinite (values)))) * 1.08;
  y = (1:n)';
  trials = arrayfun (@(r, y) [r.trials(:), 0 * r.trials(:) + y], list, y', ...
                     'UniformOutput', false);
  [now, isStrict] = deal ([[list.now]', y], [list.isStrict]);
  reach = min (max (vertcat (list.reach), -most), most);
  % a deviation is measured less simulated (tables); here measured is at 0
  f = newFigure (model, sprintf ('simulated less measured (1: %s)', of), ...
                 fliplr ({list.label}), ...
                 sprintf ('%s: %s misses most, by %.3g times %s', model, ...
                          misses(1).name, abs (list(n).now), of), ...
                 {'box', [0, n / 2, -1, 1, 0.4, n + 0.6], 'palegreen'; ...
                  'box', [0 * y, y, reach, y - 0.3, y + 0.3], 'palegrey'; ...
                  'line', [0, 0.4; 0, n + 0.6], 'ink'; ...
                  'dots', vertcat(trials{:}), 'ink'; ...
                  'ring', now(isStrict, :), 'blue'; ...
                  'diamond', now(~isStrict, :), 'blue'; ...
                  'triangle', [[list.with]', y], 'amber'});
  f.size = [360, 74 + 26 * n];
  f.xlim = most * [-1, 1];
end

function r = oneRow (page, m)
  Case = page.Case;
  t = targetAt (Case.targets, m);
  r = struct ('label', m.name, 'now', NaN, 'with', NaN, ...
              'reach', [NaN, NaN], 'trials', zeros (1, 0), ...
              'isAllowed', m.allowed > 0, 'isStrict', m.isStrict);
  [unit, measured, simulated] = deal (m.allowed, m.measured, m.simulated);
  cure = jsonAt (page.sources.gap, {'howFar', 'targets'});
  cure = cure(targetAt (cure, m));
  own = [];
  if ~isempty (t)
    own = Case.targets(t);
  end
  if ~r.isAllowed && ~isempty (cure)
    measured = jsonAt (cure, {'measured'});
    [unit, simulated] = deal (jsonNumber (cure, {'sdBefore'}, cure.sd), cure.before);
    own = changedOf (page, own);
  end
  if isempty (measured) || ~(unit > 0)
    r = [];
    return
  end
  r.now = (simulated - measured) / unit;
  if page.showsEffect && ~isempty (cure)
    r.with = (cure.after - measured) / unit;
  end
  cell_ = targetCell (page, m);
  shown = givenField (m, 'unit', cell_.unit);
  if isfield (cell_, 'factor')
    shown = cell_.unit;
  end
  r.label = labelOf (m.name, strtrim (sprintf ('%.4g %s', measured * ...
                                               givenField (cell_, 'factor', 1), shown)));
  if ~isempty (t)
    r.reach = (page.reach(t, :) - measured) / unit;
    r.trials = (givenField (own, 'each', zeros (1, 0)) - measured) / unit;
  end
end

% A target as it was measured in the new state of which is told.
function own = changedOf (page, own)
  now = char (jsonAt (page.sources.gap, {'reference', 'condition'}));
  c = find (strcmp (givenField (page.Case, 'conditions', {}), now), 1);
  if ~isempty (own) && ~isempty (c)
    own = own.changed(c);
  end
end

% An axis has room for 26 characters (htmlFigures): the value stays whole.
function text = labelOf (name, value)
  room = 25 - numel (value);
  if numel (name) > room && all (name < 128)
    name = [name(1:room - 2), '..'];
  end
  text = [name, ' ', value];
end

function key = keyOf (page, isAllowed, isReached)
  values = merge (page.verdict.usable, 'expected with the calibrated values', ...
                  'expected with the best values found');
  if ~isempty (givenField (page.verdict, 'change', '')) && ~isAllowed
    values = 'expected if nothing had changed';
  end
  key = {'line', 'ink', 'measured'; ...
         'box', 'palegreen', merge(isAllowed, 'allowed', 'noise'); ...
         'box', 'palegrey', 'reachable within your limits'; ...
         'diamond', 'blue', values};
  key = key([true, true, isReached, true], :);
  if any ([page.verdict.misses.isStrict])
    key(end + 1, :) = {'ring', 'blue', 'the same, tolerance below the scatter of a run'};
  end
  if page.showsEffect
    effect = jsonAt (page.sources.gap, {'howFar', 'effect'});
    key(end + 1, :) = {'triangle', 'amber', ['fitted with ', htmlText(plainName (effect))]};
  end
  if isfield (page.Case.targets, 'each')
    key(end + 1, :) = {'dots', 'ink', 'your trials'};
  end
end

%!test
%! % in units of what is allowed: calibrated, with the effect, own trials
%! page.verdict.usable = true;
%! page.verdict.misses = struct ('model', 'B', 'name', 'h', 'unit', 'm', ...
%!   'measured', 2, 'simulated', 2.3, 'allowed', 0.1, 'role', 'calibrate', ...
%!   'met', 0, 'share', 3, 'isStrict', false);
%! page.Case.targets = struct ('name', 'h', 'modelName', 'B', ...
%!                             'shown', struct ('unit', '', 'factor', 1), ...
%!                             'each', [1.9, 2.1]);
%! page.targets = struct ('label', '', 'unit', 'm');
%! page.reach = [NaN, NaN];
%! page.sources.gap.howFar.effect = 'tilt';
%! page.sources.gap.howFar.targets = struct ('model', 'B', 'name', 'h', ...
%!   'before', 2.3, 'after', 2.05, 'sd', 0.1, 'measured', 2);
%! page.showsEffect = true;
%! [f, key] = benchFigure (page, 'B');
%! assert (key(:, 3)', {'measured', 'allowed', 'expected with the calibrated values', ...
%!                      'fitted with tilt', 'your trials'});
%! at = @(kind) f.layers{strcmp (f.layers(:, 1), kind), 2}(:, 1)';
%! assert (at ('diamond'), 3, 1e-12);
%! assert (at ('triangle'), 0.5, 1e-12);
%! assert (at ('dots'), [-1, 1], 1e-12);
%! assert (f.ynames, {'h 2 m'});
%! page.verdict.misses.isStrict = true;
%! [f, key] = benchFigure (page, 'B');
%! assert (f.layers{strcmp (f.layers(:, 1), 'ring'), 2}(1), 3, 1e-12);
%! assert (any (strcmp (key(:, 1), 'ring')));
%! page.verdict.misses.isStrict = false;
%! assert (isempty (benchFigure (page, 'other')));
%! % a long name is cut, its value is not
%! page.verdict.misses.name = 'level of the grains behind the slit';
%! label = benchFigure (page, 'B').ynames{1};
%! assert (label, 'level of the grains .. 2 m');
%! % where no gap is told, no effect is shown
%! page.verdict.misses.name = 'h';
%! page.showsEffect = false;
%! [f, key] = benchFigure (page, 'B');
%! assert (isnan (f.layers{strcmp (f.layers(:, 1), 'triangle'), 2}(1)));
%! assert (! any (strcmp (key(:, 1), 'triangle')));
%! % a change without a calibration: in units of its noise
%! page.verdict.change = 'Changed: h.';
%! page.verdict.misses.allowed = NaN;
%! page.reach = [1, 3];
%! [f, key] = benchFigure (page, 'B');
%! assert (key(1:4, 3)', {'measured', 'noise', 'reachable within your limits', ...
%!                        'expected if nothing had changed'});

% SPDX-License-Identifier: GPL-3.0-only
