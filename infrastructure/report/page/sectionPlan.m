% SECTIONPLAN  Part of the report: which parameter sets were run.
%
% CALL: [TITLE, HTML] = sectionPlan (PAGE), see writePage and pageData
%
% Every pair of parameters: the plan, the sets run later, the sets that fit, the
% set that was found.

function [title, html] = sectionPlan (page)
  title = 'Plan and sets that fit';
  html = '';
  X = page.plan;
  later = zeros (0, columns (X));
  if ~isempty (page.surrogates)
    later = laterSets (page, vertcat (page.surrogates.X));
  end
  if (isempty (X) && isempty (later)) || columns (X) < 2
    return
  end
  sample = page.posterior(1:min (end, 200), :);
  found = page.found;
  figures = [];
  d = numel (page.Case.names);
  for i = 2:d
    for j = 1:i - 1
      f = pairFigure (page, j, i, size (X, 1));
      f = addLayer (f, 'dots', sample(:, [j, i]), 'sky');
      f = addLayer (f, 'ring', X(:, [j, i]), 'grey');
      f = addLayer (f, 'triangle', later(:, [j, i]), 'amber');
      f = addLayer (f, 'diamond', found(:, [j, i]), 'red');
      figures = [figures, f];
    end
  end
  key = {'ring', 'grey', sprintf('plan (%d sets)', rows (X))};
  if ~isempty (later)
    key(end + 1, :) = {'triangle', 'amber', ...
                       sprintf('run later or imported (%d sets)', ...
                               rows (later))};
  end
  if ~isempty (sample)
    key(end + 1, :) = {'dots', 'sky', ...
                       'sets that fit (<code>results/posterior.csv</code>)'};
  end
  if ~isempty (found)
    key(end + 1, :) = {'diamond', 'red', 'the set that was found'};
  end
  html = htmlFigures (figures, htmlKey (key), 'pairs');
end

% The last runs come after the last surrogates.
function later = laterSets (page, ran)
  isOwn = ismember ({page.runs.stage}, {'plan', 'calibration'}) & ...
          strcmp ({page.runs.status}, 'ok');
  ran = [ran; vertcat(page.runs(isOwn).params)];
  later = unique (ran(~ismember (ran, page.plan, 'rows'), :), 'rows');
end

function f = pairFigure (page, j, i, n)
  names = page.Case.names;
  alt = sprintf (['%s against %s: %d sets of the plan, the sets that fit ', ...
                  'and the set found'], names{i}, names{j}, n);
  f = newFigure ('', names{j}, names{i}, alt);
  f.title = sprintf ('%s, %s', names{i}, names{j});
  f.size = [260, 210];
  f.caption = false;
  f.xlim = page.Case.limits(:, j)';
  f.ylim = page.Case.limits(:, i)';
end

%!test
%! % the last runs come after the last surrogates; a failed one is none
%! page = situationPage ('met');
%! page.plan = [1, 1; 2, 5];
%! page.surrogates = struct ('X', [1, 1; 2, 5; 3, 3]);
%! page.runs = struct ('stage', {'plan', 'calibration', 'calibration', ...
%!                     'gap'}, 'status', {'ok', 'ok', 'failed', 'ok'}, ...
%!                     'params', {[1, 1], [4, 4], [5, 5], [6, 6]});
%! [~, html] = sectionPlan (page);
%! assert (! isempty (strfind (html, 'plan (2 sets)')));
%! assert (! isempty (strfind (html, 'run later or imported (2 sets)')));
