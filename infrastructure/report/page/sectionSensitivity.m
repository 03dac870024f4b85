% SECTIONSENSITIVITY  Part of the report: which parameter moves which target.
%
% CALL: [TITLE, HTML] = sectionSensitivity (PAGE)
%
%   PAGE  see pageData; TITLE, HTML  see pageSections
%
% See also: pageSections, sobolIndices

function [title, html] = sectionSensitivity (page)
  title = 'Sensitivity';
  html = '';
  share = jsonAt (page.sources.calibration, {'sensitivity'});
  names = page.Case.names;
  if ~isstruct (share) || ~all (isfield (share, names))
    return
  end
  S = cellfun (@(n) share.(n)(:)', names(:), 'UniformOutput', false);
  S = vertcat (S{:});
  figures = [];
  shown = shownTargets (page.Case);
  for t = shown
    figures = [figures, bars(names, S(:, t), page.Case.targets(t).name)];
  end
  cells = cell (numel (names), numel (shown) + 1);
  for j = 1:numel (names)
    cells{j, 1} = htmlText (names{j});
    for i = 1:numel (shown)
      t = shown(i);
      cells{j, i + 1} = pageNumber (page, 'plain', 'calibration', ...
                                    'sensitivity', names{j}, t);
    end
  end
  targets = cellfun (@htmlText, {page.Case.targets(shown).name}, ...
                     'UniformOutput', false);
  html = ['<p>Share of the variance of each response over the box that a ', ...
          'parameter makes, alone and with others (total Sobol index).</p>', ...
          htmlFigures(figures, ''), ...
          htmlTable('Total Sobol indices', [{'parameter'}, targets], cells)];
end

function f = bars (names, s, target)
  d = numel (names);
  [~, most] = max (s);
  alt = sprintf ('%s: %s moves it most, share %.2f', target, names{most}, ...
                 s(most));
  f = newFigure (target, 'total Sobol index', '', alt);
  f.size = [340, 60 + 26 * d];
  f.xlim = [0, max(1, max (s))];
  f.ylim = [0.4, d + 0.6];
  f.ynames = fliplr (names);
  y = (d:-1:1)';
  f = addLayer (f, 'box', [0 * y, y, 0 * y, s, y - 0.32, y + 0.32], 'blue');
end
