% BLINDRUN  Runs the truth of a sealed case: one trial of its material.
%
% CALL: Z = blindRun (LAB, TRUTH, TRIAL, WORK)
%
%   LAB    struct with problem (of newProblem)
%   TRUTH  one of blindDraw;  TRIAL  number of the trial
%   WORK   folder of the runs; finished runs in it are used again
%   Z      1 x T, results without reading errors, laboratory effects included;
%          NaN where a bench gave none
%
% See also: blindDraw, benchRun, blindForms

function Z = blindRun (lab, truth, trial, work)
  addpath (fileparts (fileparts (mfilename ('fullpath'))));
  root = startBenchmarks ();
  problem = lab.problem;
  set = struct ('runSeed', truth.seeds(trial));
  X = problem.limits(1, :) + truth.theta .* diff (problem.limits);
  for j = 1:numel (X)
    set.(problem.names{j}) = X(j);
  end
  if truth.halfStep
    set.percentRayleigh = 0.175;
  end
  [set, lines] = causesOf (truth, problem.effects, set);
  Z = NaN (1, columns (problem.sd));
  for b = 1:numel (problem.benchNames)
    bench = problem.benchNames{b};
    model = fullfile (root, 'DEMmodels', bench);
    folder = fullfile (work, sprintf ('%s-%d-%d', bench, truth.number, trial));
    [~, ~] = mkdir (work);
    script = [folder, '.sh'];
    writeAtomic (script, strjoin ([{'set -e'}, lines, {''}], "\n"));
    head = headDefaults (fullfile (model, 'data.head'));
    variables = set;
    variables.readTime = 0.4;
    unknown = setdiff (fieldnames (variables)', fieldnames (head)');
    variables = rmfield (variables, unknown);
    ofBench = problem.bench == b;
    results = benchRun (folder, model, variables, ...
                        sprintf ('bash "%s"', script));
    Z(ofBench) = results(1:sum (ofBench));
  end
  Z = laboratoryEffects (Z, truth, problem.effects);
end

function [set, lines] = causesOf (truth, effects, set)
  lines = {};
  forms = blindForms ();
  for i = 1:numel (truth.forms)
    form = forms(strcmp ({forms.name}, truth.forms{i}));
    if isempty (form)
      effect = effects(strcmp ({effects.name}, truth.cause{i}));
      values = valuesOfStrength (effect, truth.phi(i));
      for v = 1:numel (effect.variables)
        set.(effect.variables{v}) = values(v);
      end
      continue
    end
    value = truth.phi(i);
    if ~isempty (form.effect)
      effect = effects(strcmp ({effects.name}, form.effect));
      value = form.factor * valuesOfStrength (effect, value);
    end
    if ~isempty (form.variable)
      set.(form.variable) = value(1);
    end
    lines = [lines, form.patch(value(1))];
  end
end

function Z = laboratoryEffects (Z, truth, effects)
  for i = 1:numel (truth.cause)
    effect = effects(strcmp ({effects.name}, truth.cause{i}));
    if effect.laboratory && strcmp (truth.forms{i}, 'library')
      Z = Z + truth.phi(i) * (effect.offset + Z * effect.matrix);
    end
  end
end
