% PEERTABLES  The tables of runs to right values: other tools, and the floor.
%
% CALL: TABLES = peerTables ()
%
%   TABLES  struct of handles, see calibrationTables
%
% See also: writeFigures

function tables = peerTables ()
  tables = struct ('peers', @peers, 'floors', @floors, 'besideOthers', ...
                   @besideOthers, 'peersLiggghts', @peersLiggghts, 'floorsShape', ...
                   @floorsShape);
end

function values = numbers (list, name)
  values = cellfun (@str2double, {list.(name)});
end

% Right is what lies within the 1 % on the formula without noise.
function text = peers (read)
  list = read ('peers');
  kinds = {'plain', 0; 'plain', 0.1; 'rough', 0; 'rough', 0.1};
  rows_ = cell (0, 5);
  for tool = unique ({list.tool}, 'stable')
    row = {sprintf('%s', tool{1})};
    for k = 1:rows (kinds)
      own = list(strcmp ({list.tool}, tool{1}) & numbers (list, 'fail') == kinds{k, 2} & ...
                 strcmp ({list.standin}, kinds{k, 1}));
      row{end + 1} = peerText (own);
    end
    rows_(end + 1, :) = row;
  end
  text = markdownTable ({'within 1 %; runs, median; worst; crashed', 'plain', ...
                         'plain, every tenth run fails', 'rough', ...
                         'rough, every tenth run fails'}, rows_);
end

function text = peerText (own)
  text = '-';
  if isempty (own)
    return
  end
  worst = numbers (own, 'worst');
  lost = sum (~cellfun (@isempty, {own.error}) & ~strcmp ({own.error}, 'cap'));
  text = sprintf ('%d/%d; %g; %.2g %%; %d', sum (worst < 0.01), numel (own), ...
                  median (numbers (own, 'runs')), 100 * max ([worst, 0]), lost);
  if all (isnan (worst))
    text = sprintf ('0/%d; %g; -; %d', numel (own), ...
                    median (numbers (own, 'runs')), lost);
  end
end

% Each tool by its defaults: on the stand-in plain, and where they are there on
% the template Repose by LIGGGHTS.
function text = besideOthers (read)
  list = read ('peers');
  list = list(strcmp ({list.standin}, 'plain') & numbers (list, 'fail') == 0);
  real = read ('peersLiggghts');
  rows_ = cell (0, 5);
  for tool = unique ({list.tool}, 'stable')
    own = list(strcmp ({list.tool}, tool{1}));
    rows_(end + 1, :) = [{tool{1}, sprintf('%g', median (numbers (own, 'runs'))), ...
                          sprintf('%d of %d', sum (numbers (own, 'worst') < 0.01), ...
                                  numel (own))}, ...
                         liggghtsTexts(real, tool{1})];
  end
  titles = {'tool', 'formula: runs', 'right', 'LIGGGHTS: runs, core-seconds', ...
            'right'};
  if sum (~cellfun (@isempty, rows_(:, 4))) < 2
    [titles, rows_] = deal (titles(1:3), rows_(:, 1:3));   % nothing to compare with
  end
  text = markdownTable (titles, rows_);
end

function cells = liggghtsTexts (list, tool)
  cells = {'', ''};
  if isempty (list)
    return
  end
  own = list(strcmp ({list.tool}, tool));
  if ~isempty (own)
    cells = {sprintf('%g, %.0f', median (numbers (own, 'runs')), ...
                     mean (numbers (own, 'seconds'))), ...
             sprintf('%d of %d', sum (numbers (own, 'worst') < 1), numel (own))};
  end
end

function text = peersLiggghts (read)
  list = read ('peersLiggghts');
  rows_ = cell (0, 6);
  for tool = unique ({list.tool}, 'stable')
    own = list(strcmp ({list.tool}, tool{1}));
    runs = numbers (own, 'runs');
    lost = sum (~cellfun (@isempty, {own.error}) & ~strcmp ({own.error}, 'cap'));
    rows_(end + 1, :) = {tool{1}, sprintf('%d', numel (own)), ...
                         sprintf('%g (%g to %g)', median (runs), min (runs), ...
                                 max (runs)), ...
                         sprintf('%.0f', mean (numbers (own, 'seconds'))), ...
                         shareText(numbers (own, 'worst') < 1), sprintf('%d', lost)};
  end
  text = markdownTable ({'tool', 'seeds', 'runs, median (range)', ...
                         'core-seconds, mean', 'right', 'crashed'}, rows_);
end

% A seed whose values are not right, or not stated, never ends. Ratios of medians
% with intervals of 95 % from 2000 samples of the seeds of either way.
function text = floors (read)
  list = read ('floors');
  ways = {'told', 'form', 'known', 'ours'};
  rows_ = cell (0, 8);
  for name = unique ({list.standin}, 'stable')
    for w = 1:4
      own = list(strcmp ({list.standin}, name{1}) & strcmp ({list.way}, ways{w}));
      said = numbers (own, 'converged') > 0;
      isRight = said & numbers (own, 'right') > 0;
      runs{w} = numbers (own, 'runs')';
      runs{w}(~isRight) = Inf;
      texts{w} = wayText (runs{w}, sum (isRight), sum (said));
    end
    rows_(end + 1, :) = [name, texts, {ratioText(runs{2}, runs{1}), ...
                                       ratioText(runs{3}, runs{2}), ...
                                       ratioText(runs{4}, runs{2})}];
  end
  text = markdownTable ({'stand-in', 'told', 'form known', 'noise known', 'ours', ...
                         'form / told', 'known / form', 'ours / form'}, rows_);
end

% Fewer runs than the same seed without the file: mean and standard error.
function text = floorsShape (read)
  list = read ('floorsShape');
  says = {'known', 'no file'; 'bench', 'of this rig'; 'benchSmall', 'of this rig, d + 1'; ...
          'bench2', 'of this rig, d + 2'; 'other2', 'of another result, d + 2'; ...
          'otherSmall', 'of another result, d + 1'; 'half2', 'half wrong, d + 2'; ...
          'halfSmall', 'half wrong, d + 1'; 'knownSmall', 'no file, d + 1'};
  rows_ = cell (0, 4);
  for name = unique ({list.standin}, 'stable')
    ofName = list(strcmp ({list.standin}, name{1}));
    for w = 1:rows (says)
      own = ofName(strcmp ({ofName.way}, says{w, 1}));
      if isempty (own)
        continue
      end
      said = numbers (own, 'converged') > 0;
      isRight = said & numbers (own, 'right') > 0;
      runs = numbers (own, 'runs')';
      runs(~isRight) = Inf;
      rows_(end + 1, :) = {name{1}, says{w, 2}, wayText(runs, sum (isRight), sum (said)), ...
                           savedText(own, ofName(strcmp ({ofName.way}, 'known')))};
    end
  end
  text = markdownTable ({'stand-in', 'form.csv, plan (d + 3)', 'runs', ...
                         'fewer than without'}, rows_);
end

function text = savedText (own, plain)
  [isThere, at] = ismember ({own.seed}, {plain.seed});
  saved = numbers (plain(at(isThere)), 'runs') - numbers (own(isThere), 'runs');
  text = '-';
  if numel (saved) > 1 && any (saved ~= 0)
    text = sprintf ('%.1f (%.1f)', mean (saved), std (saved) / sqrt (numel (saved)));
  end
end

% Median (quartiles); of all seeds stated, of them right.
function text = wayText (runs, nRight, nSaid)
  text = '-';
  if ~isempty (runs)
    text = sprintf ('%g (%g-%g); %d/%d, %d', middle (runs, [0.5, 0.25, 0.75]), ...
                    nSaid, numel (runs), nRight);
  end
end

function text = ratioText (upper, lower)
  text = '-';
  if isempty (upper) || isempty (lower)
    return
  end
  rand ('twister', 1);
  draws = @(x) x(ceil (numel (x) * rand (numel (x), 2000)));
  ratio = sort (arrayfun (@(k, m) k / m, medians (draws (upper)), ...
                          medians (draws (lower))));
  text = sprintf ('%.2f (%.2f-%.2f)', middle (upper, 0.5) / middle (lower, 0.5), ...
                  ratio([50, 1950]));
end

function m = medians (X)
  X = sort (reshape (X, [], 2000), 1);
  n = rows (X);
  m = (X(ceil (n / 2), :) + X(min (n, floor (n / 2) + 1), :)) / 2;
end

% quantile interpolates between a number and Inf to NaN.
function q = middle (x, p)
  x = sort (x);
  n = numel (x);
  low = x(max (1, ceil (n * p)));
  high = x(min (n, floor (n * p) + 1));
  q = (low + high) / 2;
end

%!test
%! % one tool of two seeds, one right; another that crashed
%! list = struct ('tool', {'A', 'A', 'B'}, 'standin', 'plain', 'fail', '0', ...
%!                'runs', {'10', '20', '5'}, 'worst', {'0.001', '0.02', 'nan'}, ...
%!                'error', {'', 'cap', 'LinAlgError'});
%! text = peerTables ().peers (@(name) list);
%! assert (~isempty (strfind (text, '| A | 1/2; 15; 2 %; 0 |')), text);
%! assert (~isempty (strfind (text, '| B | 0/1; 5; -; 1 |')), text);
%! both = struct ('peers', list, 'peersLiggghts', []);
%! text = peerTables ().besideOthers (@(name) both.(name));
%! assert (strncmp (text, "| tool | formula: runs | right |\n", 33), text);
%! both.peersLiggghts = struct ('tool', {'A', 'A, otherwise'}, 'runs', {'9', '11'}, ...
%!                              'seconds', '100', ...
%!                              'worst', {'0.5', '1.2'}, 'error', '');
%! assert (strncmp (peerTables ().besideOthers (@(name) both.(name)), text, 33));
%! [both.peersLiggghts.tool] = deal ('A');
%! one = peerTables ().peersLiggghts (@(name) both.(name));
%! assert (~isempty (strfind (one, '| A | 2 | 10 (9 to 11) | 100 | 1/2')), one);

% SPDX-License-Identifier: GPL-3.0-only
