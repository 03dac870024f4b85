% SECTIONLEAVEONEOUT  Part of the report: how far the surrogates can be trusted.
%
% CALL: [TITLE, HTML] = sectionLeaveOneOut (PAGE), see writePage and pageData

function [title, html] = sectionLeaveOneOut (page)
  title = 'Leave-one-out';
  html = '';
  if isempty (page.surrogates)
    return
  end
  figures = [];
  for t = shownTargets (page.Case)
    figures = [figures, crossFigure(page, t)];
  end
  key = htmlKey ({'dots', 'blue', ...
                  'a run, and its prediction from all others'; ...
                  'dash', 'ink', 'where both are equal'});
  html = ['<p>Each run is predicted from all the others. Q2 is the share ', ...
          'of the variance that is predicted: 1 is perfect, 0 no better ', ...
          'than the mean; below 0.5 do not trust the surrogate.</p>', ...
          htmlFigures(figures, key, 'pairs'), qualityTable(page)];
end

function f = crossFigure (page, t)
  s = page.surrogates(t);
  predicted = s.z - s.looResidual;
  alt = sprintf ('%s: predicted against simulated for %d runs, Q2 %.2f', ...
                 page.Case.targets(t).name, numel (s.z), s.Q2);
  f = newFigure (page.Case.targets(t).name, 'simulated', 'predicted', alt);
  both = [min([s.z; predicted]); max([s.z; predicted])];
  f = addLayer (f, 'dash', [both, both], 'ink');
  f.size = [260, 190];
  f = addLayer (f, 'dots', [s.z, predicted], 'blue');
end

function html = qualityTable (page)
  n = numel (page.surrogates);
  cells = cell (n, 4);
  for t = 1:n
    s = page.surrogates(t);
    if isempty (page.sources.calibration)
      Q2 = numberText (s.Q2, 'plain');
      noise = numberText (sqrt (s.noiseVar), 'plain');
    else
      Q2 = pageNumber (page, 'plain', 'calibration', 'surrogates', t, 'Q2');
      noise = pageNumber (page, 'plain', 'calibration', 'surrogates', t, ...
                          'noiseSd');
    end
    cells(t, :) = {htmlText(page.Case.targets(t).name), Q2, noise, ...
                   sprintf('%d', numel (s.z))};
  end
  html = htmlTable ('Surrogates', {'target', 'Q2', ...
                                   'scatter of one run (sd)', 'runs'}, cells);
end

%!test
%! [problem, state, s] = smallCalibration ();
%! page.Case = struct ('names', {{'a', 'b'}}, 'limits', problem.limits, ...
%!                     'coarse', [], 'targets', ...
%!                     struct ('name', {'x', 'y'}, 'value', {4, 2}, ...
%!                             'tol', 0.02, 'isAbsolute', false));
%! page.surrogates = s;
%! page.units = {'mm', ''};
%! page.sources.calibration = [];
%! [~, html] = sectionLeaveOneOut (page);
%! assert (numel (strfind (html, '<svg viewBox="0 0 260')), 2);
%! assert (! isempty (strfind (html, 'simulated for 12 runs, Q2 ')));
