% MAKETARGETS  Makes measured.csv of a material that grows moist.
%
% CALL: octave-cli makeTargets.m WORK
%
% WORK  folder for the runs; those that are there are taken from it
%
% Not measured but simulated by LIGGGHTS: collapse, shear cell and heap of the
% toolbox, in all conditions with what the model that is calibrated lacks:
% clumps of two spheres (aspect 1.3), CDT rolling friction instead of EPSD2. The
% conditions moist and wet have cohesion of 15 and 40 kJ/m3 besides. Mean of
% three packings, and a normal reading error of sd (seeded).
%
% See also: loadInput, loadEffects

1;

% The models of the toolbox, with another rolling friction.
function otherLaw (root, folder, models)
  for name = models
    model = fullfile (folder, 'DEMmodels', name{1});
    [~, ~] = mkdir (fullfile (folder, 'DEMmodels'));
    if ~isfolder (model)
      system (sprintf ('cp -rL "%s" "%s"', ...
                       fullfile (root, 'DEMmodels', name{1}), model));
      system (sprintf (['grep -rl "rolling_friction epsd2" "%s" | xargs ' ...
                        'sed -i "s/rolling_friction epsd2/' ...
                        'rolling_friction cdt/"'], model));
    end
  end
end

function lines = rowsOf (condition, Case, Z, sd)
  lines = {};
  for t = 1:numel (Case.targets)
    own = Case.targets(t);
    tol = '2%';
    if own.tol > 0.5                      % near 0
      tol = '0.0005 abs';
    end
    value = mean (Z(:, t)) + sd(t) * randn ();
    lines{end + 1} = sprintf ('%s,%s,%s,%.5g,%g,3,%s,%s', condition, ...
                              own.modelName, nameOf (own.name), value, ...
                              sd(t), own.role, tol);
  end
end

% As results.csv of the model has it: heapSlope is slope.
function name = nameOf (name)
  short = regexprep (name, '^(heap|collapse)(?=[A-Z])', '');
  if ~strcmp (short, name)
    name = lower (short);
  end
end

function result = makeAll (root, folder)
  useLiggghts (root);
  words = argv ();
  work = make_absolute_filename (words{end});
  [~, ~] = mkdir (work);
  was = cd (fullfile (root, 'examples', 'hiddenEffect'));
  source = pwd ();
  raw = readInput (root, source);
  cd (was);
  raw.folder = work;
  otherLaw (root, work, raw.Input.model);
  raw.Input.maxNewRuns = Inf;
  raw.Input.maxCPU = 1;
  Case = withEffects (newCase (raw));
  set = [1320, 0.45, 0.4, 0.06];
  at = @(name) strcmp (Case.effectVars, name);
  names = {'reference', 'moist', 'wet'};
  cohesion = [0, 1.5e4, 4e4];
  randn ('twister', 11);
  lines = {'condition,model,name,value,sd,repeats,role,tol'};
  for c = 1:3
    E = neutralEffects (Case);
    E(at ('clumpAspect')) = 1.3;
    E(at ('cohesionPP')) = cohesion(c);
    Z = evaluateDEM (repmat (set, 3, 1), Case, (1:3)', 'gap', ...
                     newProgress (names{c}, @disp), repmat (E, 3, 1));
    lines = [lines, rowsOf(names{c}, Case, Z, [Case.targets.sd])];
  end
  writeAtomic (fullfile (folder, 'measured.csv'), sprintf ('%s\n', lines{:}));
  result.exitStatus = 0;
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startMain (@makeAll, root);

% SPDX-License-Identifier: GPL-3.0-only
