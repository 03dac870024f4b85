% COMMANDMAIN  What bin/decalioc hands to Octave: one command.
%
% CALL: octave-cli commandMain.m NAME WORD...   in the folder of the case
%
% The exit status is that of the command, 1 after an error. Each function takes
% the folder of the toolbox, that of the case and the words of the command.

1;

function [Case, words] = caseOf (root, folder, args)
  [~, words] = commandOptions (args, struct ());
  [Case, note] = caseToRead (root, folder);
  printf ('%s', note);
end

function status = sayReport (root, folder, args)
  Case = caseOf (root, folder, args);
  printf ('page  %s\n', reportPage (Case));
  status = 2 * sayChanged (Case);
end

% The trial is a run of the model that decalioc new --model makes, with few
% grains. Status 2 where something that is needed is missing or does not work.
function status = sayDoctor (root, folder, args)
  options = commandOptions (args, struct ('no_run', 'flag'));
  line = @(name, text) printf ('%-10s %s\n', name, text);
  line ('DEcalioc', [strtrim(fileread (fullfile (root, 'VERSION'))), ' in ', ...
                     root]);
  line ('Octave', sprintf ('%s (tested with 7.3, 8.4, 9.4)', version ()));
  for name = {'struct', 'optim', 'parallel', 'stk'}
    found = pkg ('list', name{1});
    line (name{1}, found{1}.version);
  end
  choice = useLiggghts (root);
  isGood = ~isempty (choice.program);
  words = {'MISSING', [choice.program, ' ', choice.version]};
  line ('LIGGGHTS', words{1 + isGood});
  line ('', choice.why);
  line ('', choice.how);
  line ('CPUs', sprintf ('%d', nproc ()));
  sayMachine (folder, line);
  sayPrograms (line);
  if isGood && ~options.no_run
    [isGood, text] = trialRun (root);
    line ('trial run', text);
  end
  status = 2 * ~isGood;
end

function sayPrograms (line)
  what = {'mpirun', 'runs on several CPUs'; ...
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
  place = privateFolder ();
  tidy = onCleanup (@() system (['rm -rf ', shellQuote(place)]));
  model = fullfile (place, 'DEMmodels', 'Trial');
  evalc ('sayNew (root, place, {''--model'', ''Trial'', place})');
  head = fullfile (model, 'data.head');
  writeAtomic (head, [fileread(head), "\nvariable filledSolid equal 4e-6\n"]);
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

function result = carryOut (root, folder, words)
  commands = struct ('new', @sayNew, 'benches', @sayBenches, ...
                     'plan', @sayPlan, ...
                     'check', @sayCheck, 'import', @sayImport, ...
                     'measure', @sayMeasure, 'submit', @saySubmit, ...
                     'status', @sayStatus, 'watch', @sayWatch, ...
                     'report', @sayReport, 'tune', @sayTune, ...
                     'export', @sayExport, 'cancel', @sayCancel, ...
                     'doctor', @sayDoctor, 'runs', @sayLibrary, ...
                     'forget', @(varargin) sayLibrary (varargin{:}, true));
  command = commands.(words{1});
  place = getenv ('DECALIOC_CALLED_IN');
  if ~isempty (place) && any (strcmp (words{1}, {'new', 'doctor', ...
                                                 'runs', 'forget'}))
    folder = place;                     % see bin/decalioc
  end
  result.exitStatus = command (root, folder, words(2:end));
end

inside = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
root = fileparts (inside);
addpath (inside);
startMain (@(root, folder) carryOut (root, folder, argv ()), root);

%!test
%! % what each command says, and its exit status
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! said = {'cancel', 0, 'no Octave worked in it; 0 run(s) ended here'; ...
%!         'export', 0, '0 runs  '; ...
%!         'export . runs.csv', 1, 'the table cannot be '; ...
%!         'doctor --no-run', [], 'stdbuf     '; ...
%!         'doctor --no-run', [], ' GiB free of '; ...
%!         'runs', 2, ' holds no runs'};
%! for row = said'
%!   [status, text] = startCommand (raw.folder, row{1});
%!   assert (isempty (row{2}) || status == row{2}, text);
%!   assert (~isempty (strfind (text, row{3})), text);
%! end
%! assert (isfile (fullfile (raw.folder, 'results', 'runs.csv')));

% SPDX-License-Identifier: GPL-3.0-only
