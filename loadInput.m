% LOADINPUT  Your form to fill in: models, targets, parameters.
%
% CALL: [Input, optim, modelVars, assign, paramLims] = loadInput ()
%
% Three parts: (1) which DEM models, (2) which targets and when to stop,
% (3) which parameters. Every field is described in docs/inputs.md. Before
% anything is run, the form is checked and all its problems are listed.
% As it stands it calibrates the container example DEMmodels/Lift100.

function [Input, optim, modelVars, assign, paramLims] = loadInput ()
  %| pragma Justify (metric, "function_length", "a form, not a program");
  % ----------------------------------------------------------------------
  % 1  DISCRETE ELEMENT MODELS
  %
  % Input.model{k}    name of model k: a folder in DEMmodels/
  % Input.cpu(k)      CPUs of one run of model k; more than 1: its runscript
  %                   calls mpirun
  Input.model{1} = 'Lift100';
  Input.cpu(1) = 1;

  % Input.maxCPU      CPUs that all runs together may use
  % Input.numOfSam    samples of the first plan. DEcalioc adds runs where they
  %                   help most, so one for each parameter and three are enough
  Input.maxCPU = 2;
  Input.numOfSam = 8;

  % Optional:
  % Input.seed        seed of plan and packings; same seed, same calibration
  % Input.timeout(k)  time limit of a run of model k (s)
  % Input.executor    'local' (default), 'slurm' or 'gridengine'
  % Input.maxNewRuns  at most so many DEM runs in this start
  % Input.coarse{k}   cheaper levels of model k, such as larger grains, that
  %                   tell where to look (docs/inputs.md)
  Input.seed = 1;

  % ----------------------------------------------------------------------
  % 2  TARGETS AND STOPPING
  %
  % optim.targetVal{k}(i)  measured value of result i of model k, in the order
  %                        in which its getResults returns them
  % optim.tolRes{k}(i)     met when |result - target| / target is below this
  % Optional: optim.targetName{k}{i}, optim.targetStd{k}(i) (standard
  % uncertainty of the measurement, same unit), optim.role{k}{i} ('calibrate',
  % or 'holdout': never used, only predicted)
  optim.targetVal{1} = [400, 0.025];
  % (the mass left scatters by 2.4 % from packing to packing: a tolerance below
  % that needs many runs at the same set before one can be sure)
  optim.tolRes{1} = [0.01, 0.03];
  optim.targetName{1} = {'bulk density (kg/m3)', 'mass left (kg)'};

  % Stopping of the stage on DEM:
  % optim.maxIter      iterations that begin at a set that turned out wrong
  % optim.maxFunEvals  parameter sets run after the first plan, never more
  % optim.tolfun       a search ends where the sum of squares falls by less
  optim.tolfun = 0.002;
  optim.maxIter = 3;
  optim.maxFunEvals = 40;

  % optim.WRL          weight of the wish for a large time step. It chooses
  %                    among sets that meet the targets; 0 switches it off
  optim.WRL = 0.5;

  % ----------------------------------------------------------------------
  % 3  MODEL VARIABLES AND DESIGN VARIABLES
  %
  % modelVars.<name>   variables of data.head that differ from the values
  %                    there, fixed in this calibration. percentRayleigh: time
  %                    step as a part of the Rayleigh time (SIMTS)
  modelVars.radiusP = 2e-3;             % m, of the small spheres
  modelVars.youngsModulusP = 5e6;       % Pa
  modelVars.poissonsRatioP = 0.3;
  modelVars.coefRestitutionPP = 0.6;
  modelVars.coefRestitutionPW = 0.69;
  modelVars.percentRayleigh = 0.35;

  % assign{j}          names of the design variables, as data.head has them
  % paramLims(:, j)    their lower and upper limit
  assign = {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
            'coefRollingFrictionPP', 'coefRollingFrictionPW'};
  paramLims = [500, 0.3, 0.3, 0.025, 0.025; ...
               800, 0.7, 0.7, 0.075, 0.075];
end
