% Flows of DEcalioc.m on stand-in models: seconds, known optimum.

%!function c = calibrationOf (folder)
%!  c = jsondecode (fileread (fullfile (folder, 'results', ...
%!                                      'calibration.json')));
%!endfunction

%!shared folder, out1, first
%! folder = [tempname(), ' with spaces'];
%! standInCase (folder);
%! writeLoadInput (folder);

%!test
%! % two models at once, from a case folder whose path holds spaces
%! [status, out1, err] = startProgram (folder);
%! assert (err, '');
%! assert (status, 0);
%! first = calibrationOf (folder);
%! assert (first.params.a, 4, 0.05);
%! assert (first.params.b, 3, 0.05);
%! assert (first.converged);
%! assert (max (abs ([first.targets.residual])) < 0.01);
%! for word = {'plan', 'running', 'Q2', 'iteration', 'measured', 'DEM runs'}
%!   assert (! isempty (strfind (out1, word{1})));
%! end

%!test
%! % at the prompt, and by run from elsewhere: a second start repeats no run and gives
%! % the same set to the last digit; so does one that may run nothing, which takes the
%! % runs after the plan from the store, too
%! n = numel (listRunFolders (folder, 'First'));
%! root = fileparts (which ('DEcalioc'));
%! writeAtomic (fullfile (folder, 'twice.m'), sprintf (strjoin ({ ...
%!   'addpath (''%s'', ''%s/tests'')', 'DEcalioc', 'a = calibration', ...
%!   'movefile (''results/calibration.json'', ''second.json'')', ...
%!   'writeLoadInput (''.'', ''Input.maxNewRuns = 0;'')', ...
%!   'run (''%s/DEcalioc.m'')', 'assert (calibration.params, a.params)', ...
%!   'assert (a.converged && calibration.converged)'}, ";\n"), root, root, root));
%! [status, out, err] = startProgram (folder, '--eval twice');
%! writeLoadInput (folder);
%! assert (err, '');
%! assert (status, 0);
%! assert (numel (strfind (out, ['case ', folder])), 2);
%! assert (numel (listRunFolders (folder, 'First')), n);
%! again = jsondecode (fileread (fullfile (folder, 'second.json')));
%! assert (again.params, first.params);
%! assert (again.demRuns.reused, ...
%!         again.demRuns.plan + again.demRuns.infill + again.demRuns.verify);
%! again = calibrationOf (folder);
%! assert (again.params, first.params);
%! assert (again.demRuns, setfield (first.demRuns, 'reused', ...
%!                                  again.demRuns.reused));

%!test
%! % what was asked for cannot be met: said, exit status 2, no set praised
%! other = tempname ();
%! standInCase (other);
%! writeLoadInput (other, 'optim.targetVal = {[7, 12], 5};');
%! [status, out, err] = startProgram (other);
%! assert (err, '');
%! assert (status, 2);
%! c = calibrationOf (other);
%! assert (! c.converged);
%! assert (! isempty (strfind (out, 'NOT CALIBRATED')));

%!test
%! % wrong input: one message without a stack, status 1, nothing run
%! other = tempname ();
%! standInCase (other);
%! writeLoadInput (other, 'paramLims = [1, 0; 0, 1]; Input.maxCpu = 3;');
%! [status, ~, err] = startProgram (other);
%! assert (status, 1);
%! assert (isempty (strfind (err, 'called from')));
%! assert (! isempty (strfind (err, 'paramLims')));
%! assert (! isempty (strfind (err, 'maxCPU')));
%! assert (! isfolder (fullfile (other, 'optim')));

%!test
%! % a published case runs unchanged: only the fields of the document, targets
%! % stacked at the end, global path in getResults, a cost function of its own
%! % that adds the Rayleigh time with weight 0.5, a runscript of one line
%! other = tempname ();
%! standInCase (other);
%! writeAtomic (fullfile (other, 'loadInput.m'), strjoin ({ ...
%!   'function [Input, optim, modelVars, assign, paramLims] = loadInput()', ...
%!   'Input.model{1} = ''First'';', 'Input.cpu(1,1) = 1;', ...
%!   'Input.maxCPU = 8;', 'Input.numOfSam = 21;', ...
%!   'optim.targetVal{1}(1) = 407;', 'optim.targetVal{1}(2) = 2800;', ...
%!   'optim.tolRes{1}(1) = 0.01;', 'optim.tolRes{1}(2) = 0.01;', ...
%!   'optim.tolfun = 0.002;', 'optim.maxIter = 3;', ...
%!   'optim.maxFunEvals = 40;', 'optim.WRL = 0.5;', ...
%!   'modelVars.poissonsRatioP = 0.3;', 'modelVars.radiusP = 2e-3;', ...
%!   'modelVars.youngsModulusP = 5e6;', ...
%!   'modelVars.percentRayleigh = 0.35;', ...
%!   'assign{1} = "densityP";', 'assign{2} = "b";', ...
%!   'paramLims = [300 1; 500 20];', ...
%!   'optim.targetVal = horzcat (optim.targetVal{:})'';', ...
%!   'optim.tolRes = horzcat (optim.tolRes{:})'';', 'endfunction'}, "\n"));
%! writeAtomic (fullfile (other, 'costFunction.m'), strjoin ({ ...
%!   'function residual = costFunction(params, evaluateFunc, varargin)', ...
%!   'result = evaluateFunc(params, varargin);', ...
%!   '[~, optim, modelVars, assign, paramLims] = loadInput();', ...
%!   'modelVars = assignParams(modelVars, params, assign);', ...
%!   'T = getMinMaxRayleigh(modelVars);', ...
%!   'residual = (result(:,1) - optim.targetVal) ./ optim.targetVal;', ...
%!   'residual(end+1) = optim.WRL * (T.max - modelVars.RLTS) ...', ...
%!   '                / (T.max - T.min);', ...
%!   'endfunction'}, "\n"));
%! model = fullfile (other, 'DEMmodels', 'First');
%! head = fullfile (model, 'data.head');
%! writeAtomic (head, strrep (fileread (head), ' a ', ' densityP '));
%! writeAtomic (head, [fileread(head), "variable radiusP equal 1\n", ...
%!   "variable youngsModulusP equal 1\nvariable poissonsRatioP equal 0.3\n", ...
%!   "variable percentRayleigh equal 0\n"]);
%! run = fullfile (model, 'runscript');
%! writeAtomic (run, strrep (fileread (run), 'v["a"]', 'v["densityP"]'));
%! [status, out, err] = startProgram (other);
%! assert (err, '');
%! assert (status, 0);
%! c = calibrationOf (other);
%! assert (c.params.densityP, 400, 4.5);
%! assert (c.params.b, 7, 0.2);
%! assert (max (abs ([c.targets.residual])) < 0.01);

%!test
%! % a second Octave in the same case folder is told so
%! lock = lockCase (folder);
%! [status, ~, err] = startProgram (folder);
%! assert (status, 1);
%! assert (! isempty (strfind (err, 'another DEcalioc')));
%! clear lock

%!test
%! % runs made elsewhere, no model folder, no new run: ends on the surrogate
%! other = tempname ();
%! mkdir (other);
%! writeLoadInput (other, 'Input.maxNewRuns = 0;');
%! rand ('twister', 1);
%! X = 10 * rand (30, 2);
%! first = [X, X(:, 1) + X(:, 2), X(:, 1) .* X(:, 2)]';
%! second = [X, X(:, 1) - X(:, 2)]';
%! writeAtomic (fullfile (other, 'runs.csv'), ...
%!   ["model,seed,a,b,First_1,First_2,Second_1\n", ...
%!    sprintf("First,1,%.17g,%.17g,%.17g,%.17g,\n", first), ...
%!    sprintf("Second,1,%.17g,%.17g,,,%.17g\n", second)]);
%! [status, out, err] = startProgram (other);
%! assert (err, '');
%! assert (status, 2);
%! c = calibrationOf (other);
%! assert (c.params.a, 4, 0.1);
%! assert (c.demRuns.plan + c.demRuns.infill + c.demRuns.verify, 0);
%! assert (! isempty (strfind (out, 'no DEM run')));

% SPDX-License-Identifier: GPL-3.0-only
