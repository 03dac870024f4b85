% BENCHRESPONSE  Draws how the results of a bench respond to its parameters.
%
% CALL: benchResponse (WORK, BENCH, NNULL)
%
% WORK   text, folder of the runs; finished runs in it are reused
% BENCH  text, name of a bench
% NNULL  number of null runs (of effectSigns): their standard deviation is the
%        band of the noise of a run
%
% Five levels of each of four friction coefficients and of the grain density,
% one run a level; one panel a result, one line a parameter, from its lowest (0)
% to its highest level (1). Writes docs/figures/response<BENCH>.svg, and the rows
% of the bench in benchmarks/results/response.csv anew.
%
% See also: effectSigns, benchRun, drawPanels
function benchResponse (work, bench, nNull)
  root = startBenchmarks ();
  names = {'coefFrictionPP', 'coefFrictionPW', 'coefRollingFrictionPP', ...
           'coefRollingFrictionPW', 'densityP'};
  levels = [0.2, 0.35, 0.5, 0.65, 0.8; 0.2, 0.35, 0.5, 0.65, 0.8; ...
            0, 0.025, 0.05, 0.1, 0.2; 0, 0.025, 0.05, 0.1, 0.2; ...
            800, 1000, 1200, 1400, 1600];
  info = resultInfo (fullfile (root, 'DEMmodels', bench));
  lines = {};
  curves = zeros (numel (names), 5, numel (info));
  for j = 1:numel (names)
    for k = 1:5
      row = oneRun (work, bench, names{j}, levels(j, k));
      curves(j, k, :) = row;
      for t = 1:numel (info)
        lines{end + 1} = sprintf ('%s,%s,%g,%s,%.5g', bench, names{j}, ...
                                  levels(j, k), info(t).name, row(t));
      end
    end
  end
  replaceRows (fullfile (root, 'benchmarks', 'results', 'response.csv'), bench, lines);
  null = [];
  for seed = benchSeeds (1:nNull)
    null = [null; oneRun(work, bench, '', 0, seed)];
  end
  drawResponse (fullfile (root, 'docs', 'figures', ...
                          ['response', bench, '.svg']), {curves, null}, ...
                levels, {names, info});
end

% The rows of this bench stand last; those of the others stay as they are.
function replaceRows (file, bench, lines)
  others = {'bench,parameter,value,result,response'};
  if isfile (file)
    [~, rest] = originOf (file);
    others = strsplit (strtrim (rest), "\n");
    others(strncmp (others, [bench, ','], numel (bench) + 1)) = [];
  end
  writeTable (file, [others, lines]);
end

function row = oneRun (work, bench, name, value, seed)
  if nargin < 5
    seed = 10007;
  end
  variables = struct ('runSeed', seed);
  if ~isempty (name)
    variables.(name) = value;
  end
  folder = fullfile (work, sprintf ('%s-%s-%g-%d', bench, name, value, seed));
  row = benchRun (folder, bench, variables);
end

function drawResponse (file, data, levels, words)
  [curves, null] = data{:};
  [names, info] = words{:};
  low = levels(:, 1);
  part = (levels - low) ./ (levels(:, end) - low);
  for t = 1:numel (info)
    for j = 1:numel (names)
      lines(j) = struct ('x', part(j, :), 'y', curves(j, :, t), 'lo', [], ...
                         'hi', []);
    end
    m = mean (null(:, t));
    s = std (null(:, t));
    panels(t) = struct ('title', sprintf ('%s (%s)', info(t).name, ...
                                          info(t).unit), ...
                        'xlabel', '', 'ylabel', '', ...
                        'range', [0, 1, NaN, NaN], 'band', m + [-s, s], ...
                        'curves', lines);
  end
  drawPanels (file, panels, 3, strrep (names, 'coef', ''));
end
