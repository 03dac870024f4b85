% RUNEFFECTS  Runs every candidate effect a few times, one after another.
%
% CALL: octave-cli runEffects.m [EACH [NAME]]
%
% EACH  runs an effect gets, with those that there are (4)
% NAME  the only effect to run
%
% The first two runs of an effect stand at the first set of predictionSets.csv
% with full and half strength (other sign where it acts both ways), the rest
% around it. First one run of each effect, then the next of each, so that the
% program can be stopped at any time. diagnoseGap.m takes what is there, and
% makes such runs by itself where Input.maxNewRuns allows; this program is for a
% machine that is not free all the time.
%
% See also: planEffectRuns, diagnoseGap

1;

function [P, E] = effectPlan (Case, effects, theta, each)
  K = numel (effects);
  data = gatherRuns (Case);
  half = diff (Case.limits) / 2;
  strengths = strengthOfValues (effects, data.E);
  known = (data.X - mean (Case.limits)) ./ half;
  Theta = zeros (0, numel (theta));
  Phi = zeros (0, K);
  order = [];
  for k = 1:K
    own = abs (strengths(:, k)) > 1e-9;
    n = max (each(k) - sum (own), 0);
    Q = planEffectRuns (n, [known(own, :), strengths(own, k)], theta, [], ...
                        effects(k).range);
    Theta = [Theta; Q(:, 1:end - 1)];
    Phi = [Phi; zeros(n, K)];
    Phi(end - n + 1:end, k) = Q(:, end);
    order = [order, 1:n];
  end
  [~, order] = sort (order);
  P = mean (Case.limits) + Theta(order, :) .* half;
  E = valuesOfStrength (effects, Phi(order, :));
end

function result = runCase (root, folder)
  useLiggghts (root);
  words = argv ();
  each = 4;
  at = find (isfinite (str2double (words)), 1);
  if ~isempty (at)
    each = str2double (words{at});
  end
  lock = lockCase (folder);
  Case = withEffects (loadCase (root, folder));
  Case.options.maxNewRuns = Inf;
  [~, cells] = readCsvTable (fullfile (folder, 'predictionSets.csv'));
  centre = str2double (cells(1, 2:end));
  theta = (centre - mean (Case.limits)) ./ (diff (Case.limits) / 2);
  effects = [];
  wanted = ismember ({Case.effects.name}, words);
  wanted = wanted | ~any (wanted);
  laboratory = [Case.effects.laboratory];
  wanted(laboratory) = [];
  for e = Case.effects(~laboratory)
    given = struct ('name', e.name, 'variables', {e.variables}, ...
                    'neutral', e.neutral, 'limits', e.limits);
    effects = [effects, newEffect(given, numel (Case.targets))];
  end
  [P, E] = effectPlan (Case, effects, theta, each * wanted);
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
