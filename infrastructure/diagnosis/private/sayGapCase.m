% SAYGAPCASE  Says what a diagnosis starts from.
%
% CALL: sayGapCase (CASE, DATA, COUNT, NOTES, SAY)
%
%   CASE   see newCase;  DATA, COUNT  of gatherRuns;  NOTES  of newProblem
%   SAY    function handle that takes one line of text
%
% What was taken into account beyond values and uncertainties has a line each.

function sayGapCase (Case, data, count, notes, say)
  say ('');
  effects = givenField (Case, 'effects', struct ('name', {}));
  lines = {sprintf('diagnoseGap: %s', Case.folder), ...
           ['  models: ', strjoin({Case.models.name}, ', ')], ...
           ['  candidate effects: ', strjoin({effects.name}, ', ')], ...
           sprintf('  runs: %d from the store, %s from runs.csv, %s of parameter values', ...
                   count.stored, countText (count.imported, 'row'), ...
                   countText (rows (data.X), 'choice'))};
  if count.noResult > 0
    lines{end + 1} = sprintf ('  runs of the store that gave no result: %d', count.noResult);
  end
  known = {'columns of runs.csv that are no parameter, cause or measured result', ...
           strjoin(count.ignored, ', '); ...
           'trials behind a value', trialsOf(Case.targets); ...
           'errors alike along a series', ...
           seriesOf(Case.targets, {Case.models.name}); ...
           'measured parameters', measuredParams(Case)};
  known = known(~cellfun (@isempty, known(:, 2)), :);
  lines = [lines, strcat({'  '}, known(:, 1), {': '}, known(:, 2))', ...
           strcat({'  note: '}, notes(:)')];
  cellfun (say, lines);
end

function text = trialsOf (targets)
  trials = [targets.trials];
  words = {};
  for n = unique (trials(trials ~= 1))
    count = sprintf ('%g', n);
    if isinf (n)
      count = 'scatter of the trials is in their sd';
    end
    words{end + 1} = sprintf ('%s (%s)', count, ...
                              strjoin ({targets(trials == n).name}, ', '));
  end
  text = strjoin (words, '; ');
end

function text = seriesOf (targets, names)
  lengths = [targets.correlation];
  words = {};
  for k = unique ([targets(lengths ~= 0).model])
    known = unique (lengths([targets.model] == k & lengths ~= 0));
    word = ['length ', strjoin(cellstr (num2str (known(:))), ', ')];
    if any (isnan (known))
      word = 'length to be estimated';
    end
    words{end + 1} = sprintf ('%s (%s)', names{k}, word);
  end
  text = strjoin (words, ', ');
end

%!test
%! Case = struct ('folder', 'here', 'effects', [], 'names', {{'mu', 'rho'}}, ...
%!                'paramMean', NaN (1, 2), 'paramSd', NaN (1, 2));
%! Case.models = struct ('name', {'A', 'B'});
%! Case.targets = struct ('name', {'x', 'y', 'z'}, 'model', {1, 1, 2}, ...
%!                        'trials', 1, 'correlation', 0);
%! data = struct ('X', [1; 2]);
%! count = struct ('stored', 1, 'noResult', 7, 'imported', 2, 'ignored', {{}});
%! text = evalc ('sayGapCase (Case, data, count, {"so"}, @disp)');
%! assert (isempty (regexp (text, 'trials|series|measured')));
%! assert (! isempty (strfind (text, 'note: so')));
%! assert (! isempty (strfind (text, 'that gave no result: 7')));
%! [Case.targets.trials] = deal (5, 1, Inf);
%! [Case.targets.correlation] = deal (2.5, 2.5, NaN);
%! [Case.paramMean(2), Case.paramSd(2)] = deal (650, 5);
%! text = evalc ('sayGapCase (Case, data, count, {"so"}, @disp)');
%! for line = {['trials behind a value: 5 (x); scatter of the trials is ', ...
%!              'in their sd (z)'], ...
%!             ['errors alike along a series: A (length 2.5), B (length ', ...
%!              'to be estimated)'], 'measured parameters: rho 650 +- 5'}
%!   assert (! isempty (strfind (text, line{1})), line{1});
%! end

% SPDX-License-Identifier: GPL-3.0-only
