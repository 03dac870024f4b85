% BENCHFIGURE  Figure of one bench: each target against what it can reach.
%
% CALL: [F, KEY] = benchFigure (PAGE, MODEL)
%
%   PAGE   see pageData
%   MODEL  name of the bench (text)
%   F      see newFigure; [] where nothing of the bench was measured
%   KEY    what its symbols mean (HTML)
%
% One row a target (of a curve its worst point): measured at 0, in units of what
% is allowed, else of its noise. The band of what the box can reach shows why a
% target is missed.

function [f, key] = benchFigure (page, model)
  key = keyOf (page);
  rows_ = page.verdict.misses;
  rows_ = rows_(strcmp ({rows_.model}, model) & ...
                ~strcmp ({rows_.role}, 'unmeasured'));
  list = [];
  for m = fliplr (rows_)
    list = [list, oneRow(page, m)];
  end
  f = [];
  if isempty (list)
    return
  end
  n = numel (list);
  unit = 'miss (1: what is allowed)';
  if ~list(1).isAllowed
    unit = 'miss (in sd of the noise)';
  end
  f = newFigure (model, unit, '', ...
                 sprintf ('%s: %s misses most, by %.3g', model, ...
                          rows_(1).name, list(n).now));
  f.size = [360, 74 + 26 * n];
  f.ynames = {list.label};
  f.ylim = [0.4, n + 0.6];
  y = (1:n)';
  all = [[list.now], [list.with], [list.trials], -1, 1];
  f.xlim = max (abs (all(isfinite (all)))) * 1.08 * [-1, 1];
  reach = vertcat (list.reach);
  reach = min (max (reach, f.xlim(1)), f.xlim(2));
  f = addLayer (f, 'box', [0 * y, y, reach, y - 0.4, y + 0.4], 'palegrey');
  f = addLayer (f, 'box', [0, n / 2, -1, 1, 0.4, n + 0.6], 'palegreen');
  f = addLayer (f, 'line', [0, 0.4; 0, n + 0.6], 'ink');
  for k = 1:n
    own = list(k).trials(:);
    f = addLayer (f, 'dots', [own, repmat(k, numel (own), 1)], 'ink');
  end
  f = addLayer (f, 'diamond', [[list.now]', y], 'blue');
  f = addLayer (f, 'triangle', [[list.with]', y], 'amber');
end

function r = oneRow (page, m)
  t = find (strcmp ({page.Case.targets.name}, m.name) & ...
            strcmp ({page.Case.targets.modelName}, m.model), 1);
  [before, after, sd] = withEffect (page, m);
  r = struct ('label', m.name, 'now', NaN, 'with', NaN, ...
              'reach', [NaN, NaN], 'trials', zeros (1, 0), ...
              'isAllowed', m.allowed > 0);
  unit = m.allowed;
  measured = m.measured;
  simulated = m.simulated;
  if ~r.isAllowed
    unit = sd;
    measured = jsonAt (page.sources.gap, {'howFar', 'targets', ...
                                          max(1, before.at), 'measured'});
    simulated = before.value;
  end
  if isempty (measured) || ~(unit > 0)
    r = [];
    return
  end
  r.now = (simulated - measured) / unit;
  r.with = (after - measured) / unit;
  name = m.unit;
  if isempty (name) && ~isempty (t)
    name = page.units{t};
  end
  r.label = labelOf (m.name, quantity (measured, name));
  if isempty (t)
    return
  end
  r.reach = (page.reach(t, :) - measured) / unit;
  if isfield (page.Case.targets, 'each')
    r.trials = (page.Case.targets(t).each - measured) / unit;
  end
end

% An axis has room for 26 characters (drawFigures): the value stays whole.
function text = labelOf (name, value)
  room = 25 - numel (value);
  if numel (name) > room && all (name < 128)
    name = [name(1:room - 2), '..'];
  end
  text = [name, ' ', value];
end

% Whether an effect was found that closes something.
% What the diagnosis says of this target, without and with the effect.
function [before, after, sd] = withEffect (page, m)
  before = struct ('value', NaN, 'at', 0);
  [after, sd] = deal (NaN);
  list = jsonAt (page.sources.gap, {'howFar', 'targets'});
  for k = 1:numel (list)
    own = jsonAt (list, {k});
    if strcmp (own.name, m.name) && strcmp (own.model, m.model)
      before = struct ('value', own.before, 'at', k);
      if page.showsEffect
        after = own.after;
      end
      sd = own.sd;
    end
  end
end

function html = keyOf (page)
  entries = {'line', 'ink', 'measured'; 'box', 'palegreen', 'allowed'; ...
             'box', 'palegrey', 'what the box of the parameters reaches'; ...
             'diamond', 'blue', 'simulated with the set'};
  if page.showsEffect
    effect = jsonAt (page.sources.gap, {'howFar', 'effect'});
    entries(end + 1, :) = {'triangle', 'amber', ...
                           ['fitted with ', htmlText(effect)]};
  end
  if isfield (page.Case.targets, 'each')
    entries(end + 1, :) = {'dots', 'ink', 'your trials'};
  end
  html = htmlKey (entries);
end

%!test
%! % in units of what is allowed: calibrated, with the effect, own trials
%! page.verdict.misses = struct ('model', 'B', 'name', 'h', 'unit', 'm', ...
%!   'measured', 2, 'simulated', 2.3, 'allowed', 0.1, 'role', 'calibrate', ...
%!   'met', 0, 'share', 3);
%! page.Case.targets = struct ('name', 'h', 'modelName', 'B', ...
%!                             'each', [1.9, 2.1]);
%! page.units = {'m'};
%! page.reach = [NaN, NaN];
%! page.sources.gap.howFar.effect = 'tilt';
%! page.sources.gap.howFar.targets = struct ('model', 'B', 'name', 'h', ...
%!   'before', 2.3, 'after', 2.05, 'sd', 0.1, 'measured', 2);
%! page.showsEffect = true;
%! f = benchFigure (page, 'B');
%! at = @(kind) f.layers(strcmp ({f.layers.kind}, kind)).data(:, 1)';
%! assert (at ('diamond'), 3, 1e-12);
%! assert (at ('triangle'), 0.5, 1e-12);
%! assert (at ('dots'), [-1, 1], 1e-12);
%! assert (f.ynames, {'h 2 m'});
%! assert (isempty (benchFigure (page, 'other')));
%! % a long name is cut, its value is not
%! page.verdict.misses.name = 'level of the grains behind the slit';
%! label = benchFigure (page, 'B').ynames{1};
%! assert (label, 'level of the grains .. 2 m');
%! % where no gap is told, no effect is shown
%! page.showsEffect = false;
%! [f, key] = benchFigure (page, 'B');
%! assert (! any (strcmp ({f.layers.kind}, 'triangle')));
%! assert (isempty (strfind (key, 'fitted with')));
