% SAYDOCTOR  Says what is installed and makes a trial run.
%
% CALL: STATUS = sayDoctor (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  folder in which it was called (text)
%   ARGS    cell of texts: '--no-run' leaves the trial run out
%   STATUS  0; 2 where something that is needed is missing or does not work
%
% The trial is a run of the model that decalioc new --model makes, with few
% grains, in a folder that is removed afterwards.

function status = sayDoctor (root, folder, args)
  options = commandOptions (args, struct ('no_run', 'flag'));
  line = @(name, text) printf ('%-10s %s\n', name, text);
  line ('DEcalioc', [strtrim(fileread (fullfile (root, 'VERSION'))), ' in ', ...
                     root]);
  line ('Octave', sprintf ('%s (tested with 7.3)', version ()));
  for name = {'struct', 'optim', 'parallel', 'stk'}
    found = pkg ('list', name{1});
    line (name{1}, found{1}.version);
  end
  choice = chosenLiggghts (root);
  isGood = ~isempty (choice.program);
  if isGood
    line ('LIGGGHTS', [choice.program, ' ', choice.version]);
  else
    line ('LIGGGHTS', 'MISSING');
  end
  line ('', choice.why);
  line ('', choice.how);
  line ('CPUs', sprintf ('%d', nproc ()));
  sayPrograms (line);
  if isGood && ~options.no_run
    [isGood, text] = trialRun (root);
    line ('trial run', text);
  end
  status = 2 * ~isGood;
end

function sayPrograms (line)
  what = {'mpirun', 'runs on several CPUs'; 'gnuplot', 'pictures'; ...
          'sbatch', 'runs on a Slurm cluster'; ...
          'stdbuf', 'the last words of a run that fails'; ...
          'pkill', 'ending runs'};
  for k = 1:rows (what)
    path = file_in_path (getenv ('PATH'), what{k, 1});
    if isempty (path)
      path = 'not there';
    end
    line (what{k, 1}, sprintf ('%s (for %s)', path, what{k, 2}));
  end
end

function [isGood, text] = trialRun (root)
  place = tempname ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(place)]));
  model = fullfile (place, 'DEMmodels', 'Trial');
  evalc ('sayNew (root, place, {''--model'', ''Trial'', place})');
  appendVariables (model, struct ('filledSolid', 4e-6));
  raw = struct ('root', root, 'folder', place);
  raw.Input = struct ('model', {{'Trial'}}, 'cpu', 1, 'maxCPU', 1, ...
                      'numOfSam', 4, 'timeout', 120);
  raw.optim = struct ('targetVal', {{[30, 0.01, 0.02]}}, ...
                      'tolRes', {{[0.1, 0.1, 0.1]}});
  raw.modelVars = struct ();
  raw.assign = {'coefFrictionPP'};
  raw.paramLims = [0.4; 0.6];
  try
    Case = newCase (raw);
    record = executeLocal (newJobs (Case, 0.5, [], 1, 'plan'), Case, ...
                           @(state) []);
    isGood = strcmp (record.status, 'ok');
    text = sprintf ('%s, %s', record.status, record.message);
    if isGood
      text = sprintf ('ok, %.1f s, angle of repose %.1f deg', ...
                      record.seconds, record.results(1));
    end
  catch err
    isGood = false;
    text = err.message;
  end
end
