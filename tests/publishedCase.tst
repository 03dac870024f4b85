% A case as published runs unchanged, but for what docs/inputs.md lists: each
% row of that table is refused for the reason that stands there, and for no
% other.

%!function names = inTable ()
%!  root = fileparts (fileparts (which ('startToolbox')));
%!  text = fileread (fullfile (root, 'docs', 'inputs.md'));
%!  from = strfind (text, '## A published case');
%!  text = text(from:from + strfind (text(from + 5:end), "\n## ")(1));
%!  names = {};
%!  for row = strsplit (text, "\n")
%!    cells = strsplit (row{1}, '|');
%!    if numel (cells) == 5
%!      found = regexp (cells{3}, '`(\w+)`', 'tokens');
%!      names = [names, found{:}];
%!    end
%!  end
%!endfunction

%!function reasons = reasonsOf (change)
%!  folder = tempname ();
%!  raw = goodPublished (folder);
%!  for k = 1:rows (change)
%!    raw = setIn (raw, change{k, 1}, change{k, 2});
%!  end
%!  p = checkCase (raw);
%!  reasons = strrep ({p.id}, 'DEcalioc:checkCase:', '');
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (folder, 's');
%!endfunction

%!function raw = setIn (raw, path, value)
%!  words = strsplit (path, '.');
%!  if strcmp (words{1}, 'FILE')
%!    file = fullfile (raw.folder, 'DEMmodels', 'Toy', ...
%!                     strjoin (words(2:end), '.'));
%!    fid = fopen (file, 'w');
%!    fputs (fid, value);
%!    fclose (fid);
%!  elseif numel (words) == 1
%!    raw.(words{1}) = value;
%!  else
%!    raw.(words{1}).(words{2}) = value;
%!  end
%!endfunction

%!assert (isempty (reasonsOf (cell (0, 2))))

%!test
%! changes = {{'Input.maxCpu', 8}, 'unknownField'; ...
%!            {'Input.numOfSam', 2}, 'tooFewSamples'; ...
%!            {'optim.targetVal', [400; 0]}, 'zeroTarget'; ...
%!            {'optim.tolRes', [0.01; 1]}, 'badTolRes'; ...
%!            {'optim.targetVal', [400; 1; 2]; ...
%!             'optim.tolRes', [0.1; 0.1; 0.1]}, 'targetCount'; ...
%!            {'assign', {'densityP', 'coefFrictionPX'}}, 'unknownVariable'; ...
%!            {'assign', {'densityP', 'material'}}, 'variableStyle'; ...
%!            {'FILE.in.Toy', ["include data.head\nvariable densityP ", ...
%!                             "equal 7\n"]}, 'overwrittenInScript'; ...
%!            {'assign', {'densityP', 'coefRestitutionPP'}}, ...
%!            'overwrittenVariable'; ...
%!            {'assign', {'densityP', 'SIMTS'}}, 'reservedName'; ...
%!            {'modelVars', struct('radiusP', 2e-3, ...
%!                                 'percentRayleigh', 0.3)}, ...
%!            'missingRayleigh'; ...
%!            {'modelVars.coefRestitutionPP', 1.2}, 'impossibleValue'; ...
%!            {'paramLims', [800, 0.3; 500, 0.7]}, 'badLimits'; ...
%!            {'FILE.runscript', "true\r\n"}, 'windowsLineEnds'; ...
%!            {'FILE.data.head', char([255, 254, 97, 0])}, 'badEncoding'; ...
%!            {'FILE.runscript', "noSuchDEM < in.Toy\n"}, 'missingProgram'; ...
%!            {'FILE.runscript', "mpirun -np 4 true\n"}, 'rankMismatch'};
%! for k = 1:rows (changes)
%!   reasons = unique (reasonsOf (changes{k, 1}));
%!   assert (any (strcmp (reasons, changes{k, 2})), ...
%!           [changes{k, 2}, ': ', strjoin(reasons, ' ')]);
%! end
%! assert (sort (inTable ()), sort (changes(:, 2)'));

% A whole case in the form of the published files, solved by the published
% method, beside nonlin_residmin called by hand: on the functions of KrigingFuns
% from the box centre, then on the formula of the model.

%!function folder = publishedFolder (cap)
%!  folder = tempname ();
%!  standInCase (folder);
%!  writeAtomic (fullfile (folder, 'loadInput.m'), strjoin ({ ...
%!   'function [Input, optim, modelVars, assign, paramLims] = loadInput()', ...
%!   'Input.model{1} = "First";', 'Input.cpu(1,1) = 1;', ...
%!   'Input.maxCPU = 2;', 'Input.numOfSam = 8;', ...
%!   'optim.targetVal{1}(1) = 407;', 'optim.targetVal{1}(2) = 2800;', ...
%!   'optim.tolRes{1}(1) = 0.001;', 'optim.tolRes{1}(2) = 0.001;', ...
%!   'optim.tolfun = 0.002;', 'optim.maxIter = 3;', ...
%!   sprintf('optim.maxFunEvals = %d;', cap), 'optim.WRL = 0.05;', ...
%!   'optim.method = "published";', ...
%!   'modelVars.poissonsRatioP = 0.3;', 'modelVars.radiusP = 2e-3;', ...
%!   'modelVars.youngsModulusP = 5e6;', ...
%!   'assign{1} = "densityP";', 'assign{2} = "b";', ...
%!   'paramLims = [300 1; 500 20];', ...
%!   'optim.targetVal = horzcat (optim.targetVal{:})'';', ...
%!   'optim.tolRes = horzcat (optim.tolRes{:})'';', 'endfunction'}, "\n"));
%!  % a row of the user's own follows the Rayleigh row
%!  writeAtomic (fullfile (folder, 'costFunction.m'), strjoin ({ ...
%!   'function residual = costFunction(params, evaluateFunc, varargin)', ...
%!   'result = evaluateFunc(params, varargin);', ...
%!   '[~, optim, modelVars, assign, paramLims] = loadInput();', ...
%!   'modelVars = assignParams(modelVars, params, assign);', ...
%!   'T = getMinMaxRayleigh(modelVars);', ...
%!   'residual = (result(:,1) - optim.targetVal) ./ optim.targetVal;', ...
%!   'residual(end+1) = optim.WRL * (T.max - modelVars.RLTS) ...', ...
%!   '                / (T.max - T.min);', ...
%!   'residual(end+1) = 0.02 * (params(2) - 8) / 8;', ...
%!   'endfunction'}, "\n"));
%!  model = fullfile (folder, 'DEMmodels', 'First');
%!  head = fullfile (model, 'data.head');
%!  writeAtomic (head, [strrep(fileread (head), ' a ', ' densityP '), ...
%!    "variable radiusP equal 1\nvariable youngsModulusP equal 1\n", ...
%!    "variable poissonsRatioP equal 0.3\n"]);
%!  run = fullfile (model, 'runscript');
%!  writeAtomic (run, strrep (fileread (run), 'v["a"]', 'v["densityP"]'));
%!endfunction

%!function p = byHand (folder)
%!  here = cd (folder);
%!  addpath (fullfile (folder, 'KrigingFuns'));
%!  clear loadInput costFunction
%!  onKriging = @(p, varargin) [KM_fun_1(p); KM_fun_2(p)];
%!  formula = @(p, varargin) [p(1) + p(2); p(1) * p(2)];
%!  box = {'lbound', [300; 1], 'ubound', [500; 20], 'MaxIter'};
%!  p = nonlin_residmin (@(p) costFunction (p, onKriging), [400; 10.5], ...
%!                       optimset (box{:}, 1000));
%!  p = nonlin_residmin (@(p) costFunction (p, formula), p, ...
%!                       optimset (box{:}, 3, 'TolFun', 0.002))';
%!  rmpath (fullfile (folder, 'KrigingFuns'));
%!  cd (here);
%!  clear loadInput costFunction
%!endfunction

%!test
%! pkg load -nodeps struct optim
%! for cap = [10, 40]
%!   folder = publishedFolder (cap);
%!   [status, out, err] = startProgram (folder);
%!   assert (err, '');
%!   assert (status, 2);
%!   c = jsondecode (fileread (fullfile (folder, 'results', ...
%!                                       'calibration.json')));
%!   p = byHand (folder);
%!   confirm_recursive_rmdir (false, 'local');
%!   rmdir (folder, 's');
%!   for word = {'DEM, iteration 0: res', 'DEM, iteration 1: res'}
%!     assert (! isempty (strfind (out, word{1})));
%!   end
%!   assert ([c.params.densityP, c.params.b], p, [0.2, 0.02]);
%!   assert (c.demRuns.infill, 0);
%!   assert (c.demRuns.verify <= cap);
%!   assert (! c.converged);
%!   assert (c.ending.code, 'published');
%!   for word = {'2 rows beyond the targets, all are', ...
%!               'values that were found: residuals (%)'}
%!     assert (! isempty (strfind (out, word{1})));
%!   end
%! end

% Each function with the published arguments alone, in the folder of a case.
%!test
%! folder = publishedFolder (10);
%! here = cd (folder);
%! back = onCleanup (@() cd (here));
%! clear loadInput costFunction
%! limits = [300, 1; 500, 20];
%! plan = GenerateExperPlan (limits, 3, [folder, '/']);
%! assert (isfile ('ExperimentalPlan_DoE.csv'));
%! [n, per, left] = SplitToCPU (2, 3, 1);
%! [main, rest] = SplitExPlan (plan, n, per, left);
%! assert ({numel(main), numel(rest)}, {2, 1});
%! formula = @(p) [p(1) + p(2); p(1) * p(2)];
%! assert (Start ([main{1}, 1], {'First'}), formula (plan(1, :)), 1e-9);
%! assert (runScript ([main{2}, 1], 'First'), ...
%!         num2cell (formula (plan(2, :))'), 1e-9);
%! assert (getLastFoldersName ([folder, '/'], 'First'), '0002');
%! name = newFolderName (getLastFoldersNumber ([folder, '/'], 'First') + 1);
%! assert (createNewFolder ('First', name));
%! [~, ~, modelVars, assign] = loadInput ();
%! writeHead ('First', assignParams (modelVars, plan(3, :), assign), name);
%! writeParams ('First', [rest{1}, 1], name);
%! assert (startSimulation ('First', name), 0);
%! assert (evaluateDEM (plan(1, :)'), formula (plan(1, :)), 1e-9);
%! T = getMinMaxRayleigh (modelVars);
%! assert ([T.min, T.max], getRayleigh (2e-3, limits(:, 1)', 5e6, 0.3), 1e-12);
%! vals = struct ('iteration', 1, 'residual', [0.0005; -0.0005; 0.4]);
%! evalc ('stop = userInt (plan(1, :)'', vals, ''iter'', true);');
%! assert (stop);
%! name = getOptimFolder (plan(1, :)){1};
%! assert (csvread (fullfile ('optim', 'First', name, 'params.csv')), ...
%!         plan(1, :), 1e-9);
%! cd (here);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
