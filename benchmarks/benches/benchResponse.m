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
% to its highest level (1). Writes
% docs/figures/response<BENCH>.svg and benchmarks/results/response<BENCH>.csv.
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
  fid = fopen (fullfile (root, 'benchmarks', 'results', ...
                         ['response', bench, '.csv']), 'w');
  fprintf (fid, ['parameter,value', repmat(',%s', 1, numel (info)), '\n'], ...
           info.name);
  curves = zeros (numel (names), 5, numel (info));
  for j = 1:numel (names)
    for k = 1:5
      row = oneRun (work, bench, names{j}, levels(j, k));
      curves(j, k, :) = row;
      fprintf (fid, '%s,%g', names{j}, levels(j, k));
      fprintf (fid, ',%.5g', row);
      fprintf (fid, "\n");
    end
  end
  fclose (fid);
  null = [];
  for seed = benchSeeds (1:nNull)
    null = [null; oneRun(work, bench, '', 0, seed)];
  end
  drawResponse (fullfile (root, 'docs', 'figures', ...
                          ['response', bench, '.svg']), {curves, null}, ...
                levels, {names, info});
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
