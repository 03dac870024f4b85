% CAMPAIGNTABLE  What each effect does to each target, in noise of a run.
%
% CALL: [CHANGE, COUNT, LINES] = campaignTable (PROBLEM, DATA)
%
%   PROBLEM     struct of newProblem
%   DATA        struct X, E, Z, replicate, see importRuns
%   CHANGE      K x T: change of the mean from strength 0 to 1 in the middle of
%               the box, over the standard deviation of one run; NaN where fewer
%               than three runs with this effect alone have the result
%   COUNT       K x T, these runs; of the laboratory, which needs none, all runs
%   LINES       1 x n cell of text, the same as a table: a row a target
%
% The means are those of the emulator of the diagnosis.
%
% See also: campaign, fitEmulator

function [change, count, lines] = campaignTable (problem, data)
  emulator = fitEmulator (problem, data, gapOptions ([]));
  phi = strengthOfValues (problem.effects, data.E);
  K = numel (emulator.effect);
  middle = zeros (1, emulator.p);
  noise = sqrt (emulator.noiseVar);
  change = zeros (K, numel (noise));
  count = zeros (K, numel (noise));
  for k = 1:K
    own = phi(:, k) ~= 0 & sum (phi ~= 0, 2) == 1;
    own = own | emulator.effect(k).laboratory;
    count(k, :) = sum (isfinite (data.Z(own, :)), 1);
    change(k, :) = (predictGap (emulator, k, [middle, 1]) - ...
                    predictGap (emulator, [], middle)) ./ noise;
  end
  change(count < 3) = NaN;
  lines = {['| target | noise of a run | ', ...
            strjoin({problem.effects.name}, ' | '), ' |'], ...
           repmat('|---', 1, K + 2)};
  lines{2}(end + 1) = '|';
  for t = 1:numel (noise)
    texts = arrayfun (@textOf, change(:, t)', 'UniformOutput', false);
    lines{end + 1} = sprintf ('| %s | %.2g | %s |', ...
                              problem.targetNames{t}, noise(t), ...
                              strjoin (texts, ' | '));
  end
end

function text = textOf (value)
  text = sprintf ('%+.1f', value);
  if isnan (value)
    text = 'no results';
  elseif abs (value) < 0.05
    text = '0';
  end
end

%!test
%! % effect a adds 3 to the first result, seen through noise of deviation 0.2;
%! % effect b has runs that gave nothing. A 90 % band of the noise estimate with
%! % 12 replicates is 0.66 to 1.33 times the true one: 15 lies in 8 to 30
%! pkg load stk optim
%! rand ('twister', 4); randn ('twister', 4);
%! names = {'a', 'b'};
%! for k = 1:2
%!   effects(k) = struct ('name', names{k}, 'variables', {names(k)}, ...
%!                        'neutral', 0, 'limits', [0; 1]);
%! end
%! problem = newProblem (struct ('value', [1, 1], 'sd', [0.2, 0.2], ...
%!                                     'limits', [0, 0; 1, 1], ...
%!                                     'bench', [1, 1], 'effects', effects));
%! X = rand (20, 2);
%! data.X = [X; X(1:12, :); rand(12, 2)];
%! E = zeros (44, 2);
%! E(33:40, 1) = rand (8, 1);
%! E(41:44, 2) = rand (4, 1);
%! data.E = E;
%! data.Z = [data.X * [2; 1] + 3 * E(:, 1), data.X * [1; -1]] + ...
%!          0.2 * randn (44, 2);
%! data.Z(41:44, 2) = NaN;
%! data.replicate = [ones(20, 1); 2 * ones(12, 1); ones(12, 1)];
%! [change, count, lines] = campaignTable (problem, data);
%! assert (count, [8, 8; 4, 0]);
%! assert (change(1, 1) > 8 && change(1, 1) < 30);
%! assert (abs (change(1, 2)) < 5);
%! assert (isnan (change), logical ([0, 0; 0, 1]));
%! assert (numel (lines), 4);
%! assert (~isempty (strfind (lines{4}, 'no results')));

% SPDX-License-Identifier: GPL-3.0-only
