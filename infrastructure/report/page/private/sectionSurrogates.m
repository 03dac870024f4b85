% SECTIONSURROGATES  Parts of the report: which sets were run; each response
% along each parameter; how far the surrogates can be trusted.
%
% CALL: LIST = sectionSurrogates (), see writePage

function list = sectionSurrogates ()
  list = {'sectionplan', 'Runs, and values that fit', @plan, {}; ...
          'sectionslices', 'Results along each parameter', @slices, ...
          {'surrogates'}; ...
          'sectionleaveoneout', 'Leave-one-out', @leaveOneOut, ...
          {'surrogates'}};
end

% Every pair of parameters: the plan, what was run later, the values that fit, the
% calibrated ones; on the diagonal how the values that fit spread.
function html = plan (page)
  html = '';
  X = page.plan;
  later = zeros (0, columns (X));
  if ~isempty (page.surrogates)
    later = laterSets (page, vertcat (page.surrogates.X));
  end
  if isempty (X) && isempty (later) && isempty (page.posterior)
    return
  end
  sets = {'dots', page.posterior(1:min (end, 200), :), 'sky', ...
          'values that fit (<code>results/posterior.csv</code>)'; ...
          'ring', X, 'grey', ['plan (', countText(rows (X), 'run'), ')']; ...
          'triangle', later, 'amber', ...
          ['run later or imported (', countText(rows (later), 'run'), ')']; ...
          'diamond', page.found, 'red', page.foundWord};
  isSeen = ~cellfun (@isempty, sets(:, 2));
  figures = [];
  for i = 1:numel (page.Case.names)
    for j = 1:i - 1
      figures = [figures, pairFigure(page, j, i, sets(:, 1:3))];
    end
    figures = [figures, marginFigure(page, i)];
  end
  key = [sets(isSeen, [1, 3, 4]); {'area', 'midblue', 'spread of the values that fit'; ...
                                   'xbar', 'blue', 'value and 90 % interval'}];
  html = htmlFigures (figures, key, 'corner');
end

% The last runs come after the last surrogates.
function later = laterSets (page, ran)
  if ~isempty (page.runs)
    isOwn = ismember ({page.runs.stage}, {'plan', 'calibration'}) & ...
            strcmp ({page.runs.status}, 'ok');
    ran = [ran; vertcat(page.runs(isOwn).params)];
  end
  later = unique (ran(~ismember (ran, page.plan, 'rows'), :), 'rows');
end

function f = pairFigure (page, j, i, layers)
  names = page.Case.names;
  limits = page.Case.limits;
  layers(:, 2) = eachOf (@(X) X(:, min ([j, i], columns (X))), layers(:, 2));
  f = newFigure (sprintf ('%s, %s', names{i}, names{j}), names{j}, names{i}, ...
                 sprintf ('%s against %s: runs, values that fit, calibrated values', ...
                          names{i}, names{j}), layers);
  f = mergeFields (f, struct ('place', [i, j], 'size', [260, 210], 'caption', false, ...
                              'xlim', limits(1:2, j)', 'ylim', limits(1:2, i)', ...
                              'xlog', any (limits(3:end, j)), ...
                              'ylog', any (limits(3:end, i))));
end

function f = marginFigure (page, j)
  name = page.Case.names{j};
  box = page.Case.limits(:, j);
  value = jsonAt (page.sources.calibration, {'params', name});
  known = jsonAt (page.sources.calibration, {'interval90', name})(:)';
  bar = zeros (0, 4);
  if isscalar (value)
    known(isnan (known)) = value;       % not printed
    known = [known, value];
    bar = [value, -0.12, min(known), max(known)];
  end
  f = newFigure (name, name, '', sprintf ('How the values of %s that fit spread', name), ...
                 {'area', histogram(page.posterior(:, j:end), box), 'midblue'; ...
                  'xbar', bar, 'blue'; 'diamond', bar(:, 1:2), 'blue'});
  f = mergeFields (f, struct ('place', [j, j], 'size', [260, 210], 'caption', false, ...
                              'xlim', box(1:2)', 'xlog', any (box(3:end)), ...
                              'ylim', [-0.25, 1.05], 'ynames', {{' '}}));
end

function area = histogram (sample, box)
  area = zeros (0, 3);
  if rows (sample) > 20
    edges = fromUnit (linspace (0, 1, 26)', box);
    counts = histc (sample(:, 1), edges);
    counts(end - 1) = counts(end - 1) + counts(end);
    counts = counts(1:end - 1) / max (counts);
    x = repelem (edges, 2)(2:end - 1);
    area = [x, 0 * x, repelem(counts, 2)];
  end
end

% Cuts through the found set (before there is one: through the box centre).
function html = slices (page)
  html = '';
  centre = page.found;
  what = page.foundWord;
  if isempty (centre)
    centre = boxCentre (page.Case.limits);
    what = 'the centre of the limits (nothing has been found yet)';
  end
  names = page.Case.names;
  c = page.sources.calibration;
  for t = shownTargets (page.Case)
    share = cellfun (@(name) jsonNumber (c, {'sensitivity', name, t}, 1), names);
    figures = eachOf (@(j) slice (page, t, j, centre), find (share >= 0.1));
    html = [html, '<h3>', htmlText(page.Case.targets(t).name), '</h3>', ...
            htmlFigures([figures{:}])];
  end
  coarse = repmat ([' Runs at coarser levels are shown where the surrogate ', ...
                    'carries them over to the last one.'], 1, ~isempty (page.Case.coarse));
  key = {'line', 'blue', 'mean response (Kriging)'; ...
         'area', 'midblue', 'its 90 % interval'; ...
         'area', 'paleblue', '90 % of single runs'; ...
         'area', 'palegreen', 'tolerance about the measured value'; ...
         'disc', 'red', 'runs nearby (within a quarter of the limits)'; ...
         'ring', 'grey', 'other runs'; ...
         'dash', 'ink', 'measured, and the calibrated value'};
  html = ['<p>One parameter moves, the others stay at ', what, '. Parameters that make ', ...
          'less than a tenth of the variance are left out.', coarse, '</p>', ...
          htmlKey(key), html];
end

function f = slice (page, t, j, centre)
  s = page.surrogates(t);
  T = page.Case.targets(t);
  limits = page.Case.limits;
  name = page.Case.names{j};
  x = fromUnit (linspace (0, 1, 31)', limits(:, j));
  P = repmat (centre, 31, 1);
  P(:, j) = x;
  [m, v] = predictSurrogate (s, P);
  inner = studentQuantile (0.95, s.df) * sqrt (v);
  outer = studentQuantile (0.95, s.df) * sqrt (v + s.noiseVar);
  z = carriedOver (s);
  others = toUnit (s.X, limits) - toUnit (centre, limits);
  others(:, j) = 0;
  isNear = all (abs (others) <= 0.25, 2);
  ends = limits(1:2, j);
  half = halfWidth (T);
  range = [m - outer; m + outer; z; T.value];
  range = [min(range), max(range)];
  range = range + 0.04 * max (diff (range), 1e-12) * [-1, 1];
  f = newFigure ([T.name, ', ', name], name, ...
                 withUnit (T.name, page.targets(t).unit), ...
                 sprintf ('%s along %s: mean response from %.4g to %.4g', ...
                          T.name, name, m(1), m(end)), ...
                 {'area', [x, m - outer, m + outer], 'paleblue'; ...
                  'area', [ends, T.value + half * [-1, 1; -1, 1]], ...
                  'palegreen'; ...
                  'area', [x, m - inner, m + inner], 'midblue'; ...
                  'ring', [s.X(~isNear, j), z(~isNear)], 'grey'; ...
                  'dash', [ends, [T.value; T.value]], 'ink'; ...
                  'line', [x, m], 'blue'; ...
                  'disc', [s.X(isNear, j), z(isNear)], 'red'; ...
                  'dash', [centre([j; j])(:), range'], 'ink'});
  f.caption = false;
  f.xlim = ends';
  f.xlog = any (limits(3:end, j));
  f.ylim = range;
end

% What a run at another level would be at the one that counts.
function z = carriedOver (s)
  z = s.z(:);
  if ~isempty (s.extra)
    z = z - predictSurrogate (s, [s.X, s.extra]) + predictSurrogate (s, s.X);
  end
end

function html = leaveOneOut (page)
  key = {'dots', 'blue', 'a run, and its prediction from all others'; ...
         'dash', 'ink', 'where both are equal'};
  figures = eachOf (@(t) crossFigure (page, t), shownTargets (page.Case));
  row = @(t, s) {targetCell(page, page.Case.targets(t)), s.Q2, sqrt(s.noiseVar), numel(s.z)};
  html = ['<p>Each run is predicted from all the others. Q2 is the share ', ...
          'of the variance that is predicted: 1 is perfect, 0 no better ', ...
          'than the mean; below 0.5 do not trust the fitted surface.</p>', ...
          believedForm(page), ...
          htmlFigures([figures{:}], key, 'pairs'), ...
          tableHtml(newTable (page, 'surrogates', 'Fitted surfaces', ...
                              {'result', '', 'name'; 'Q2', '', 'probability'; ...
                               'scatter of a run', '', 'error'; 'runs', '', 'count'}, ...
                              eachOf (@(t) row (t, page.surrogates(t)), ...
                                      1:numel (page.surrogates))))];
end

function html = believedForm (page)
  html = '';
  form = jsonAt (page.sources.calibration, {'form'});
  if ~isempty (form) && form.known > 0
    html = sprintf (['<p>The model brings form.csv: it knows how %s the parameters, and ', ...
                     'the runs bear it out for %d of them.</p>'], ...
                    countText (form.known, 'result follows', 'results follow'), ...
                    form.believed);
  end
end

function f = crossFigure (page, t)
  s = page.surrogates(t);
  name = page.Case.targets(t).name;
  predicted = s.z - s.looResidual;
  both = [min([s.z; predicted]); max([s.z; predicted])];
  f = newFigure (name, 'simulated', 'predicted', ...
                 sprintf (['%s: predicted against simulated for %d runs, ', ...
                           'Q2 %.2f'], name, numel (s.z), s.Q2), ...
                 {'dash', [both, both], 'ink'; ...
                  'dots', [s.z, predicted], 'blue'});
  f.size = [260, 190];
end

%!test
%! [problem, state, s] = smallCalibration ();
%! page.Case = struct ('names', {{'a', 'b'}}, 'limits', problem.limits, ...
%!                     'coarse', [], 'targets', ...
%!                     struct ('name', {'x', 'y'}, 'modelName', 'M', 'value', {4, 2}, ...
%!                             'tol', 0.02, 'isAbsolute', false, ...
%!                             'shown', struct ('unit', '', 'factor', 1), ...
%!                             'curve', 0));
%! page.surrogates = s;
%! page.targets = struct ('label', {'', ''}, 'unit', {'mm', ''});
%! [page.found, page.foundWord] = deal ([0.5, 1], 'the best values so far');
%! page.sources.calibration = [];
%! parts = sectionSurrogates ()(:, 3);
%! html = parts{3} (page);
%! assert (numel (strfind (html, '<svg viewBox="0 0 260')), 2);
%! assert (! isempty (strfind (html, 'simulated for 12 runs, Q2 ')));
%! assert (isempty (strfind (html, 'form.csv')));
%! page.sources.calibration.form = struct ('known', 2, 'believed', 1);
%! said = '2 results follow the parameters, and the runs bear it out for 1 ';
%! assert (! isempty (strfind (parts{3} (page), said)));
%! page.sources.calibration.sensitivity = struct ('a', [0.9, 0.5], ...
%!                                                'b', [0.05, 0.5]);
%! html = parts{2} (page);
%! assert (numel (strfind (html, '<svg viewBox="0 0 340')), 3);
%! % x = 3 + a + b / 2
%! ends = regexp (html, 'x along a: mean response from (\S+) to (\S+)"', ...
%!                'tokens', 'once');
%! assert (str2double (ends(:)'), [3.5, 4.5], 0.05);
%! % the last runs come after the last surrogates; a failed one is none
%! page.plan = [1, 1; 2, 5];
%! page.posterior = zeros (0, 2);
%! page.surrogates = struct ('X', [1, 1; 2, 5; 3, 3]);
%! page.runs = struct ('stage', {'plan', 'calibration', 'calibration', ...
%!                     'gap'}, 'status', {'ok', 'ok', 'failed', 'ok'}, ...
%!                     'params', {[1, 1], [4, 4], [5, 5], [6, 6]});
%! html = parts{1} (page);
%! assert (! isempty (strfind (html, 'plan (2 runs)')));
%! assert (! isempty (strfind (html, 'run later or imported (2 runs)')));

% SPDX-License-Identifier: GPL-3.0-only
