% PLANTTARGETS  Makes the targets of an example: a laboratory of benches.
%
% CALL: VALUES = plantTargets (WORK, BENCHES, VARIABLES, SEEDS, SD)
%
% WORK       text, folder of the runs; finished runs in it are reused
% BENCHES    1 x B cell of names of benches
% VARIABLES  scalar struct of what the material is: parameters and one effect
%            at the strength that is to be found; a bench gets those that its
%            data.head declares
% SEEDS      1 x n, packings; a target is the mean over them
% SD         1 x B cell of 1 x m: measurement noise, drawn from the first seed
% VALUES     1 x B cell of 1 x m; printed as lines for loadInput.m
%
% The targets of examples/hiddenEffect and examples/fourBenches are made so;
% their README gives the call. They are simulated, not measured.
%
% See also: benchRun
function values = plantTargets (work, benches, variables, seeds, sd)
  root = startBenchmarks ();
  rand ('twister', seeds(1));
  randn ('twister', seeds(1));
  values = cell (1, numel (benches));
  for b = 1:numel (benches)
    head = headDefaults (fullfile (root, 'DEMmodels', benches{b}, 'data.head'));
    names = intersect (fieldnames (variables)', fieldnames (head)');
    rows = [];
    for seed = seeds
      set = struct ('runSeed', seed);
      for name = names
        set.(name{1}) = variables.(name{1});
      end
      folder = fullfile (work, sprintf ('%s-planted-%d', benches{b}, seed));
      rows = [rows; benchRun(folder, benches{b}, set)];
    end
    values{b} = mean (rows, 1) + sd{b} .* randn (1, numel (sd{b}));
    printf ('  optim.targetVal{%d} = [%s];\n', b, ...
            strjoin (cellfun (@(v) sprintf ('%.5g', v), ...
                              num2cell (values{b}), 'UniformOutput', false), ...
                     ', '));
  end
end

% SPDX-License-Identifier: GPL-3.0-only
