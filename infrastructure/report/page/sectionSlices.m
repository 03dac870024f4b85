% SECTIONSLICES  Part of the report: each response along each parameter.
%
% CALL: [TITLE, HTML] = sectionSlices (PAGE), see writePage and pageData
%
% Cuts through the found set (before there is one: through the box centre).

function [title, html] = sectionSlices (page)
  title = 'Responses through the set';
  html = '';
  if isempty (page.surrogates)
    return
  end
  centre = page.found;
  what = 'the set that was found';
  if isempty (centre)
    centre = mean (page.Case.limits, 1);
    what = 'the centre of the box (no set has been found yet)';
  end
  for t = shownTargets (page.Case)
    T = page.Case.targets(t);
    figures = [];
    for j = find (moving (page, t))
      figures = [figures, slice(page, t, j, centre)];
    end
    html = [html, '<h3>', htmlText(T.name), '</h3>', ...
            htmlFigures(figures, '')];
  end
  key = htmlKey ({'line', 'blue', 'mean response (Kriging)'; ...
                  'area', 'midblue', 'its 90 % interval'; ...
                  'area', 'paleblue', '90 % of single runs'; ...
                  'area', 'palegreen', 'tolerance about the measured value'; ...
                  'disc', 'red', ...
                  'runs near the set (within a quarter of the box)'; ...
                  'ring', 'grey', 'other runs'; ...
                  'dash', 'ink', 'measured, and where the set lies'});
  coarse = '';
  if ~isempty (page.Case.coarse)
    coarse = [' Runs at coarser levels are shown where the surrogate ', ...
              'carries them over to the last one.'];
  end
  html = ['<p>One parameter moves, the others stay at ', what, '; left ', ...
          'out are those that make less than a tenth of its variance.', ...
          coarse, '</p>', key, html];
end

% The parameters that move a target; all where nobody knows.
function yes = moving (page, t)
  names = page.Case.names;
  yes = true (1, numel (names));
  for j = 1:numel (names)
    share = jsonAt (page.sources.calibration, {'sensitivity', names{j}, t});
    yes(j) = isempty (share) || share >= 0.1;
  end
end

% What a run at another level would be at the one that counts.
function z = carriedOver (s)
  z = s.z(:);
  if ~isempty (s.level)
    z = z - predictSurrogate (s, [s.X, s.level]) + predictSurrogate (s, s.X);
  end
end

function f = slice (page, t, j, centre)
  s = page.surrogates(t);
  T = page.Case.targets(t);
  limits = page.Case.limits;
  name = page.Case.names{j};
  x = linspace (limits(1, j), limits(2, j), 31)';
  P = repmat (centre, 31, 1);
  P(:, j) = x;
  [m, v] = predictSurrogate (s, P);
  inner = studentQuantile (0.95, s.df) * sqrt (v);
  outer = studentQuantile (0.95, s.df) * sqrt (v + s.noiseVar);
  alt = sprintf ('%s along %s: mean response from %.4g to %.4g', T.name, ...
                 name, m(1), m(end));
  f = newFigure ([T.name, ', ', name], name, ...
                 withUnit (T.name, page.units{t}), alt);
  f.caption = false;
  f.xlim = limits(:, j)';
  half = halfWidth (T);
  f = addLayer (f, 'area', [x, m - outer, m + outer], 'paleblue');
  f = addLayer (f, 'area', [f.xlim', T.value + half * [-1, 1; -1, 1]], ...
                'palegreen');
  f = addLayer (f, 'area', [x, m - inner, m + inner], 'midblue');
  z = carriedOver (s);
  others = (s.X - centre) ./ diff (limits);
  others(:, j) = 0;
  isNear = all (abs (others) <= 0.25, 2);
  f = addLayer (f, 'ring', [s.X(~isNear, j), z(~isNear)], 'grey');
  f = addLayer (f, 'dash', [f.xlim', [T.value; T.value]], 'ink');
  f = addLayer (f, 'line', [x, m], 'blue');
  f = addLayer (f, 'disc', [s.X(isNear, j), z(isNear)], 'red');
  everything = [m - outer; m + outer; z; T.value];
  f.ylim = [min(everything), max(everything)];
  f.ylim = f.ylim + 0.04 * max (diff (f.ylim), 1e-12) * [-1, 1];
  f = addLayer (f, 'dash', [centre(j), f.ylim(1); centre(j), f.ylim(2)], ...
                'ink');
end

%!test
%! [problem, state, s] = smallCalibration ();
%! page.Case = struct ('names', {{'a', 'b'}}, 'limits', problem.limits, ...
%!                     'coarse', [], 'targets', ...
%!                     struct ('name', {'x', 'y'}, 'value', {4, 2}, ...
%!                             'tol', 0.02, 'isAbsolute', false));
%! page.surrogates = s;
%! page.units = {'mm', ''};
%! page.found = [0.5, 1];
%! page.sources.calibration.sensitivity = struct ('a', [0.9, 0.5], ...
%!                                                'b', [0.05, 0.5]);
%! [~, html] = sectionSlices (page);
%! assert (numel (strfind (html, '<svg viewBox="0 0 340')), 3);
%! % x = 3 + a + b / 2
%! ends = regexp (html, 'x along a: mean response from (\S+) to (\S+)"', ...
%!                'tokens', 'once');
%! assert (str2double (ends(:)'), [3.5, 4.5], 0.05);
