% BENCHPICTURES  Draws the picture of each bench from a finished run.
%
% CALL: benchPictures (WORK)
%
% WORK  text, folder with the runs of effectSigns; the first null run of each
%       bench is drawn into DEMmodels/<bench>/picture.svg
%
% DEMmodels/<bench>/sample/picture.csv says what is drawn: a panel for each dump
% and the walls in it, of the kinds line (x1, z1 to x2, z2) and ring (the circle
% in the box of these two corners), all in m. A model without it has no picture.
%
% See also: benchPicture, effectSigns
function benchPictures (work)
  root = startBenchmarks ();
  for file = glob (fullfile (root, 'DEMmodels', '*', 'sample', 'picture.csv'))'
    folder = fileparts (fileparts (file{1}));
    [~, bench] = fileparts (folder);
    run = fullfile (work, [bench, '--0-10007']);
    [dumps, walls] = panelsOf (file{1});
    last = @(dump) readDump (fullfile (run, dump)){end};
    benchPicture (fullfile (folder, 'picture.svg'), ...
                  cellfun (last, dumps, 'UniformOutput', false), walls);
  end
end

% Names of the dumps in the order of the table, and the lines of each (m x 4).
function [dumps, walls] = panelsOf (file)
  [~, words] = readCsvTable (file);
  dumps = unique (words(:, 1), 'stable')';
  for p = 1:numel (dumps)
    walls{p} = zeros (0, 4);
    for k = find (strcmp (words(:, 1), dumps{p}))'
      at = str2double (words(k, 3:6));
      if strcmp (words{k, 2}, 'ring')
        at = ring (at);
      end
      walls{p} = [walls{p}; at];
    end
  end
end

function lines = ring (at)
  a = (0:60).' / 60 * 2 * pi;
  edge = (at(1:2) + at(3:4)) / 2 + (at(3) - at(1)) / 2 * [cos(a), sin(a)];
  lines = [edge(1:end - 1, :), edge(2:end, :)];
end

%!test
%! % the tables of all benches: known kinds, numbers
%! root = startBenchmarks ();
%! files = glob (fullfile (root, 'DEMmodels', '*', 'sample', 'picture.csv'));
%! assert (numel (files) >= 5);
%! for file = files'
%!   [~, words] = readCsvTable (file{1});
%!   assert (ismember (words(:, 2), {'line', 'ring'}), file{1});
%!   assert (isfinite (str2double (words(:, 3:6))), file{1});
%! end

% SPDX-License-Identifier: GPL-3.0-only
