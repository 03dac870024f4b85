% RUNEFFECTS  Runs every candidate effect a few times, one after another.
%
% CALL: octave-cli runEffects.m [EACH]
%
% EACH  runs an effect gets (4)
%
% After DEcalioc.m: the first two runs of an effect stand at the calibrated set
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
  Q = cell (1, K);
  for k = 1:K
    Q{k} = planEffectRuns (each, zeros (0, numel (theta) + 1), theta, [], ...
                           effects(k).range);
  end
  Theta = zeros (0, numel (theta));
  Phi = zeros (0, K);
  for i = 1:each
    for k = 1:K
      Theta(end + 1, :) = Q{k}(i, 1:end - 1);
      Phi(end + 1, k) = Q{k}(i, end);
    end
  end
  P = mean (Case.limits) + Theta .* diff (Case.limits) / 2;
  E = valuesOfStrength (effects, Phi);
end

function result = runCase (root, folder)
  startToolbox (root, folder);
  useLiggghts (root);
  each = 4;
  if ~isempty (argv ()) && isfinite (str2double (argv (){end}))
    each = str2double (argv (){end});
  end
  lock = lockCase (folder);
  Case = withEffects (loadCase (root, folder));
  Case.options.maxNewRuns = Inf;
  found = jsondecode (fileread (fullfile (folder, 'results', ...
                                          'calibration.json')));
  centre = cellfun (@(name) found.params.(name), Case.names);
  theta = (centre - mean (Case.limits)) ./ (diff (Case.limits) / 2);
  effects = [];
  for e = Case.effects(~[Case.effects.laboratory])
    given = struct ('name', e.name, 'variables', {e.variables}, ...
                    'neutral', e.neutral, 'limits', e.limits);
    effects = [effects, newEffect(given, numel (Case.targets))];
  end
  [P, E] = effectPlan (Case, effects, theta, each);
  evaluate = newEvaluate (Case, newLedger (), @(text) disp (text));
  Z = evaluate (P, ones (rows (P), 1), 'gap', E);
  printf ('%d of %d runs gave results\n', sum (all (isfinite (Z), 2)), ...
          rows (P));
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'), ...
         fullfile (root, 'infrastructure', 'case'));
startMain (@runCase, root);
