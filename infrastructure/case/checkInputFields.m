% CHECKINPUTFIELDS  Checks the first part of the input: models and CPUs.
%
% CALL: [P, OWN] = checkInputFields (INPUT)
%
%   INPUT  scalar struct, the Input of loadInput
%   P      1 x n faults, see checkFault
%   OWN    cell of the fields that nothing here reads, see checkFields
%
% Reasons: unknownField missingField badModelList unsafeName duplicateModel
% badCpu cpuCount badMaxCPU tooFewCPU badNumOfSam badSeed badMaxNewRuns
% badReplicates badTimeout timeoutCount badExecutor missingProgram
% badStore, those of checkCoarse, and those of each executor for
% Input.<its name>
%
% See also: checkCase, checkModels, describeExecutor

function [p, own] = checkInputFields (Input)
  known = {'model', 'cpu', 'maxCPU', 'numOfSam', 'seed', 'timeout', ...
           'executor', 'maxNewRuns', 'replicates', 'store', 'coarse'};
  rules = {'maxCPU', 'badMaxCPU', 1, 1e6, 'integer', true, ...
           'Set the number of CPUs that all runs together may use.'; ...
           'numOfSam', 'badNumOfSam', 1, 1e6, 'integer', true, ...
           'Set the number of samples: design variables + 3 is a start.'; ...
           'seed', 'badSeed', 0, 2^32 - 1, 'integer', false, ...
           'Set Input.seed = 1, or leave it out.'; ...
           'replicates', 'badReplicates', 0, 1e4, 'integer', false, ...
           'Set Input.replicates = 1, or leave it out.'};
  [queues, q] = checkExecutorFields (Input);
  [p, own] = checkFields (Input, 'Input', [known, queues]);
  p = [p, checkModelList(Input), ...
       checkCpu(Input), checkScalars(Input, 'Input', rules), ...
       checkTimeout(Input), checkBudget(Input), ...
       checkExecutor(Input), checkStoreName(Input), ...
       checkCoarse(Input, countModels (Input)), q];
end

function p = checkModelList (Input)
  p = checkFault ();
  cure = 'Write Input.model{1} = ''Lift100''; with the name of your model.';
  expected = 'a cell of names of folders in DEMmodels';
  if ~isfield (Input, 'model')
    p = checkFault ('missingField', 'Input.model', expected, 'nothing', ...
                    cure);
    return
  end
  names = Input.model;
  if checkIs ('text', names)
    names = {names};
  end
  if ~iscell (names) || isempty (names) || ~isvector (names)
    p = checkFault ('badModelList', 'Input.model', expected, ...
                    checkShow (names), cure);
    return
  end
  isText = cellfun (@(n) checkIs ('text', n), names);
  for k = 1:numel (names)
    p = [p, checkModelName(names{k}, k, names(find (isText(1:k - 1))))];
  end
end

function p = checkModelName (name, k, earlier)
  p = checkFault ();
  field = sprintf ('Input.model{%d}', k);
  if ~checkIs ('text', name)
    p = checkFault ('badModelList', field, 'the name of a folder', ...
                    checkShow (name), ...
                    'Write the name of a folder in DEMmodels.');
  elseif ~checkFolderName (name)
    p = checkFault ('unsafeName', field, ...
                    ['a plain folder name (letters, digits, _ - + . and ' ...
                     'no dot or minus first)'], checkShow (name), ...
                    'Rename the folder in DEMmodels and write that name.');
  elseif any (strcmp (name, earlier))
    p = checkFault ('duplicateModel', field, 'another model', ...
                    sprintf ('%s a second time', checkShow (name)), ...
                    ['Name each model once; a second use needs a copy of ' ...
                     'its folder.']);
  end
end

function p = checkCpu (Input)
  p = checkFault ();
  cure = 'Set Input.cpu(k) to the CPUs that one run of model k takes.';
  if ~isfield (Input, 'cpu')
    p = checkFault ('missingField', 'Input.cpu', 'one integer a model', ...
                    'nothing', cure);
    return
  end
  cpu = Input.cpu;
  if ~checkIs ('vector', cpu) || ~all (cpu >= 1 & cpu <= 1e6) || ...
      ~all (cpu == fix (cpu))
    p = checkFault ('badCpu', 'Input.cpu', 'integers from 1', ...
                    checkShow (cpu), cure);
    return
  end
  nModels = countModels (Input);
  if nModels > 0 && numel (cpu) ~= nModels
    p = checkFault ('cpuCount', 'Input.cpu', ...
                    sprintf ('%d value(s), one a model', nModels), ...
                    sprintf ('%d value(s)', numel (cpu)), cure);
  end
  p = [p, checkEnough(Input, cpu)];
end

function p = checkEnough (Input, cpu)
  p = checkFault ();
  if ~isfield (Input, 'maxCPU') || ~checkIs ('integer', Input.maxCPU) || ...
      Input.maxCPU < 1
    return
  end
  [most, k] = max (double (cpu));
  if Input.maxCPU < most
    p = checkFault ('tooFewCPU', 'Input.maxCPU', ...
                    sprintf ('at least Input.cpu(%d) = %d', k, most), ...
                    checkShow (Input.maxCPU), ...
                    'Raise Input.maxCPU or lower Input.cpu.');
  end
end

function n = countModels (Input)
  n = 0;
  if isfield (Input, 'model') && iscell (Input.model)
    n = numel (Input.model);
  elseif isfield (Input, 'model') && checkIs ('text', Input.model)
    n = 1;
  end
end

function p = checkTimeout (Input)
  p = checkFault ();
  if ~isfield (Input, 'timeout') || checkIs ('nothing', Input.timeout)
    return
  end
  t = Input.timeout;
  cure = ['Set Input.timeout(k) to the seconds after which a run of model ' ...
          'k is ended, or leave it out.'];
  if ~checkIs ('vector', t) || any (isinf (t)) || any (t <= 0)
    p = checkFault ('badTimeout', 'Input.timeout', ...
                    'seconds above 0 (NaN: the default rule)', ...
                    checkShow (t), cure);
  elseif countModels (Input) > 0 && numel (t) > countModels (Input)
    p = checkFault ('timeoutCount', 'Input.timeout', ...
                    sprintf ('at most %d value(s), one a model', ...
                             countModels (Input)), ...
                    sprintf ('%d values', numel (t)), cure);
  end
end

function p = checkBudget (Input)
  p = checkFault ();
  if ~isfield (Input, 'maxNewRuns') || checkIs ('nothing', Input.maxNewRuns)
    return
  end
  n = Input.maxNewRuns;
  if ~isequal (n, Inf) && (~checkIs ('integer', n) || n < 0)
    p = checkFault ('badMaxNewRuns', 'Input.maxNewRuns', ...
                    'an integer from 0, or Inf', checkShow (n), ...
                    'Leave it out where the number of runs has no limit.');
  end
end

% An executor may have fields in Input.<its name>, which it checks itself.
function [names, p] = checkExecutorFields (Input)
  p = checkFault ();
  names = cell (1, 0);
  for name = executorNames ()
    check = describeExecutor (name{1}).check;
    if ~isempty (check)
      names = [names, name];
      if isfield (Input, name{1})
        p = [p, check(Input.(name{1}))];
      end
    end
  end
end

function p = checkExecutor (Input)
  p = checkFault ();
  executors = executorNames ();
  if ~isfield (Input, 'executor') || checkIs ('nothing', Input.executor)
    return
  end
  name = Input.executor;
  if ~checkIs ('text', name) || ~any (strcmp (name, executors))
    p = checkFault ('badExecutor', 'Input.executor', ...
                    ['one of ', strjoin(executors, ', ')], ...
                    checkShow (name), ...
                    'Leave it out to run on this machine.');
    return
  end
  program = describeExecutor (name).program;
  if ~isempty (program) && isempty (file_in_path (getenv ('PATH'), program))
    p = checkFault ('missingProgram', 'Input.executor', ...
                    sprintf ('a program %s on the PATH', program), 'none', ...
                    ['Start on a machine of the cluster, or leave it out ' ...
                     'to run here.']);
  end
end

function p = checkStoreName (Input)
  p = checkFault ();
  if isfield (Input, 'store') && ~checkIs ('nothing', Input.store) && ...
      ~(checkIs ('text', Input.store) && numel (Input.store) < 1024)
    p = checkFault ('badStore', 'Input.store', 'the path of a folder', ...
                    checkShow (Input.store), ...
                    'Leave it out to keep the runs in the case folder.');
  end
end

%!shared good
%! good = struct ('model', {{'A', 'B'}}, 'cpu', [1; 2], 'maxCPU', 2, ...
%!                'numOfSam', 21);
%!assert (isempty (checkInputFields (good)))
%!test
%! bad = setfield (good, 'maxCPU', 1);
%! assert (checkInputFields (bad).id, ...
%!         'DEcalioc:checkCase:tooFewCPU');
%!test
%! bad = setfield (good, 'model', {'A', '../B'});
%! assert (checkInputFields (bad).id, ...
%!         'DEcalioc:checkCase:unsafeName');
%!test
%! home = getenv ('PATH');
%! setenv ('PATH', '/nowhere');
%! p = checkInputFields (setfield (good, 'executor', 'slurm'));
%! setenv ('PATH', home);
%! assert (p.id, 'DEcalioc:checkCase:missingProgram');
