% MWECASE  Writes the case folder of one attempt of the benchmark mwe.
%
% CALL: mweCase (FOLDER, METHOD, SETTING, SEED)
%
% FOLDER   text, made if it is not there
% METHOD   'ours' or 'published', see mwe; 'levels', see containerLevels
% SETTING  struct: root (toolbox), scale ('default' or 'full'), cpus
% SEED     integer, Input.seed
%
% The case is the toolbox's own loadInput.m with the lines that differ appended
% to it, and a copy of the model Lift100 that leaves its user time in cpu.txt
% and takes its insertion seed from modelVars.ownSeed where that is not 0: the
% published model has one seed written in its script.
%
% See also: mwe, mweAttempt

function mweCase (folder, method, setting, seed)
  model = fullfile (folder, 'DEMmodels', 'Lift100');
  [~, ~] = mkdir (model);
  copyfile (fullfile (setting.root, 'DEMmodels', 'Lift100', '*'), model);
  writeAtomic (fullfile (model, 'runscript'), ...
               ["TIMEFORMAT=%U\n", ...
                "{ time liggghts -in in.Lift100 >&3 2>&4; } ", ...
                "3>&1 4>&2 2> cpu.txt\n"]);
  withOwnSeed (model);
  lines = {sprintf('Input.seed = %d;', seed), ...
           sprintf('Input.maxCPU = %d;', setting.cpus), ...
           'optim.tolRes{1} = [0.01, 0.01];'};
  if strcmp (method, 'levels')
    lines{end + 1} = ['Input.coarse = {struct(''variable'', ''scaleP'', ', ...
                      '''levels'', [1.6, 1.25, 1])};'];
  elseif strcmp (setting.scale, 'full')
    lines{end + 1} = 'modelVars.scaleP = 1;';
  end
  if any (strcmp (method, {'ours', 'levels'}))
    lines = [lines, {'Input.replicates = 2;', 'optim.confidence = 0.7;', ...
                     'optim.maxFunEvals = 6;'}];
  else
    lines = [lines, {'Input.numOfSam = 21;', 'optim.WRL = 0;', ...
                     sprintf('modelVars.ownSeed = %d;', ...
                             runSeed (0, 1, seed)), ...
                     'modelVars.useCriteria = 0;', ...
                     'modelVars.fillMethod = 1;', 'modelVars.skin = 4e-3;'}];
  end
  form = strtrim (fileread (fullfile (setting.root, 'loadInput.m')));
  form = regexprep (form, 'end$', [strjoin(lines, "\n"), "\nend\n"]);
  writeAtomic (fullfile (folder, 'loadInput.m'), form);
end

function withOwnSeed (model)
  head = fullfile (model, 'data.head');
  writeAtomic (head, [fileread(head), "variable ownSeed equal 0\n", ...
                      'variable insertSeed equal ', ...
                      "v_ownSeed+v_runSeed*(v_ownSeed==0)\n"]);
  script = fullfile (model, 'in.Lift100');
  writeAtomic (script, strrep (fileread (script), '${runSeed}', ...
                               '${insertSeed}'));
end

%!test % both cases load, and differ in what the benchmark says
%! root = startBenchmarks ();
%! setting = struct ('root', root, 'scale', 'default', 'cpus', 1);
%! folder = tempname ();
%! mweCase (folder, 'published', setting, 7);
%! here = cd (folder);
%! [Input, optim, modelVars] = loadInput ();
%! cd (here);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! assert ([Input.seed, Input.numOfSam, optim.WRL], [7, 21, 0]);
%! assert (modelVars.useCriteria, 0);
%! assert (isprime (modelVars.ownSeed));
