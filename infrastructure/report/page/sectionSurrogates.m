% SECTIONSURROGATES  Parts of the report: which sets were run; each response
% along each parameter; how far the surrogates can be trusted.
%
% CALL: LIST = sectionSurrogates (), see writePage

function list = sectionSurrogates ()
  list = {'sectionplan', 'Plan and sets that fit', @plan, {}; ...
          'sectionslices', 'Responses through the set', @slices, ...
          {'surrogates'}; ...
          'sectionleaveoneout', 'Leave-one-out', @leaveOneOut, ...
          {'surrogates'}};
end

% Every pair of parameters: the plan, the sets run later, the sets that fit, the
% set that was found.
function html = plan (page)
  html = '';
  X = page.plan;
  later = zeros (0, columns (X));
  if ~isempty (page.surrogates)
    later = laterSets (page, vertcat (page.surrogates.X));
  end
  if (isempty (X) && isempty (later)) || columns (X) < 2
    return
  end
  sets = {'ring', 'grey', sprintf('plan (%d sets)', rows (X)), X; ...
          'triangle', 'amber', sprintf('run later or imported (%d sets)', ...
                                       rows (later)), later; ...
          'dots', 'sky', ...
          'sets that fit (<code>results/posterior.csv</code>)', ...
          page.posterior(1:min (end, 200), :); ...
          'diamond', 'red', 'the set that was found', page.found};
  isSeen = ~cellfun (@isempty, sets(:, 4));
  isSeen(1) = true;
  [j, i] = find (triu (true (numel (page.Case.names)), 1));
  layers = sets([3, 1, 2, 4], [1, 4, 2]);
  figures = arrayfun (@(j, i) pairFigure (page, j, i, layers), j', i', ...
                      'UniformOutput', false);
  html = htmlFigures ([figures{:}], sets(isSeen, 1:3), 'pairs');
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
  layers(:, 2) = cellfun (@(X) X(:, [j, i]), layers(:, 2), ...
                          'UniformOutput', false);
  f = newFigure (sprintf ('%s, %s', names{i}, names{j}), names{j}, names{i}, ...
                 sprintf (['%s against %s: %d sets of the plan, the sets ', ...
                           'that fit and the set found'], names{i}, ...
                          names{j}, rows (page.plan)), layers);
  f.size = [260, 210];
  f.caption = false;
  f.xlim = page.Case.limits(1:2, j)';
  f.ylim = page.Case.limits(1:2, i)';
  f.xlog = any (page.Case.limits(3:end, j));
  f.ylog = any (page.Case.limits(3:end, i));
end

% Cuts through the found set (before there is one: through the box centre).
function html = slices (page)
  html = '';
  centre = page.found;
  what = 'the set that was found';
  if isempty (centre)
    centre = boxCentre (page.Case.limits);
    what = 'the centre of the box (no set has been found yet)';
  end
  for t = shownTargets (page.Case)
    figures = [];
    for j = 1:numel (page.Case.names)
      share = jsonAt (page.sources.calibration, ...
                      {'sensitivity', page.Case.names{j}, t});
      if isempty (share) || share >= 0.1
        figures = [figures, slice(page, t, j, centre)];
      end
    end
    html = [html, '<h3>', htmlText(page.Case.targets(t).name), '</h3>', ...
            htmlFigures(figures)];
  end
  coarse = '';
  if ~isempty (page.Case.coarse)
    coarse = [' Runs at coarser levels are shown where the surrogate ', ...
              'carries them over to the last one.'];
  end
  key = {'line', 'blue', 'mean response (Kriging)'; ...
         'area', 'midblue', 'its 90 % interval'; ...
         'area', 'paleblue', '90 % of single runs'; ...
         'area', 'palegreen', 'tolerance about the measured value'; ...
         'disc', 'red', 'runs near the set (within a quarter of the box)'; ...
         'ring', 'grey', 'other runs'; ...
         'dash', 'ink', 'measured, and where the set lies'};
  html = ['<p>One parameter moves, the others stay at ', what, '; left ', ...
          'out are those that make less than a tenth of its variance.', ...
          coarse, '</p>', htmlKey(key), html];
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
                 withUnit (T.name, page.units{t}), ...
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
  if ~isempty (s.level)
    z = z - predictSurrogate (s, [s.X, s.level]) + predictSurrogate (s, s.X);
  end
end

function html = leaveOneOut (page)
  key = {'dots', 'blue', 'a run, and its prediction from all others'; ...
         'dash', 'ink', 'where both are equal'};
  figures = arrayfun (@(t) crossFigure (page, t), shownTargets (page.Case), ...
                      'UniformOutput', false);
  html = ['<p>Each run is predicted from all the others. Q2 is the share ', ...
          'of the variance that is predicted: 1 is perfect, 0 no better ', ...
          'than the mean; below 0.5 do not trust the surrogate.</p>', ...
          htmlFigures([figures{:}], key, 'pairs'), ...
          htmlTable('Surrogates', ...
                    {'target', 'Q2', 'scatter of one run (sd)', 'runs'}, ...
                    @(t) qualityRow (page, t), numel (page.surrogates))];
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

function cells = qualityRow (page, t)
  s = page.surrogates(t);
  numbers = {numberText(s.Q2), numberText(sqrt (s.noiseVar))};
  if ~isempty (page.sources.calibration)
    at = @(field) pageNumber (page, 'plain', 'calibration', 'surrogates', t, ...
                              field);
    numbers = {at('Q2'), at('noiseSd')};
  end
  cells = {htmlText(page.Case.targets(t).name), numbers{:}, ...
           sprintf('%d', numel (s.z))};
end

%!test
%! [problem, state, s] = smallCalibration ();
%! page.Case = struct ('names', {{'a', 'b'}}, 'limits', problem.limits, ...
%!                     'coarse', [], 'targets', ...
%!                     struct ('name', {'x', 'y'}, 'value', {4, 2}, ...
%!                             'tol', 0.02, 'isAbsolute', false, ...
%!                             'curve', 0));
%! page.surrogates = s;
%! page.units = {'mm', ''};
%! page.found = [0.5, 1];
%! page.sources.calibration = [];
%! parts = sectionSurrogates ()(:, 3);
%! html = parts{3} (page);
%! assert (numel (strfind (html, '<svg viewBox="0 0 260')), 2);
%! assert (! isempty (strfind (html, 'simulated for 12 runs, Q2 ')));
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
%! assert (! isempty (strfind (html, 'plan (2 sets)')));
%! assert (! isempty (strfind (html, 'run later or imported (2 sets)')));
