% RUNEFFECTS  Runs every candidate effect a few times, one after another.
%
% CALL: octave-cli runEffects.m EACH [NAME...]
%
% EACH  runs an effect gets, with those that there are
% NAME  the only effects to run
%
% The first two runs of an effect stand at the mean of the sets that fit series
% 1 (results/posterior.csv) with full and half strength (other sign where it
% acts both ways), the rest around it (planEffectRuns). First one run of each
% effect, then the next of each, so that the program can be stopped any time.
% diagnoseGap.m takes what is there.
%
% See also: planEffectRuns, diagnoseGap, loadEffects

1;

function effects = effectsOf (Case)
  effects = [];
  for e = Case.effects(~[Case.effects.laboratory])
    given = struct ('name', e.name, 'variables', {e.variables}, ...
                    'neutral', e.neutral, 'limits', e.limits);
    effects = [effects, newEffect(given, numel (Case.targets))];
  end
end

function [P, E] = effectPlan (Case, theta, each, names)
  effects = effectsOf (Case);
  data = gatherRuns (Case);
  middle = mean (Case.limits);
  half = diff (Case.limits) / 2;
  strengths = strengthOfValues (effects, data.E);
  known = (data.X - middle) ./ half;
  Theta = zeros (0, numel (theta));
  Phi = zeros (0, numel (effects));
  order = [];
  for k = find (ismember ({effects.name}, names))
    own = abs (strengths(:, k)) > 1e-9;
    n = max (each - sum (own), 0);
    Q = planEffectRuns (n, [known(own, :), strengths(own, k)], ...
                        (theta - middle) ./ half, [], effects(k).range);
    Theta = [Theta; Q(:, 1:end - 1)];
    Phi(end + (1:n), k) = Q(:, end);
    order = [order, 1:n];
  end
  [~, order] = sort (order);
  P = middle + Theta(order, :) .* half;
  E = valuesOfStrength (effects, Phi(order, :));
end

function result = runCase (root, folder)
  useLiggghts (root);
  addpath (folder);
  words = argv ();
  lock = lockCase (folder);
  Case = withEffects (loadCase (root, folder));
  Case.options.maxNewRuns = Inf;
  [~, cells] = readCsvTable (fullfile (folder, 'results', 'posterior.csv'));
  theta = mean (str2double (cells), 1);
  names = words(2:end);
  if isempty (names)
    names = {Case.effects.name};
  end
  [P, E] = effectPlan (Case, theta, str2double (words{1}), names);
  Z = evaluateDEM (P, Case, 1, 'gap', newProgress ('gap', @disp), E);
  printf ('%d of %d runs gave results\n', sum (all (isfinite (Z), 2)), ...
          rows (P));
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startMain (@runCase, root);

% SPDX-License-Identifier: GPL-3.0-only
