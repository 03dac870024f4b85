% COMMANDMAIN  What bin/decalioc hands to Octave: one command.
%
% CALL: octave-cli commandMain.m NAME WORD...   in the folder of the case
%
% The exit status is that of the command, 1 after an error. What a command needs
% no options for stands here; each function takes the folder of the toolbox, the
% folder of the case and the words of the command.
%
% See also: sayNew, sayCheck, sayStatus, sayDoctor, cancelCase, sayLibrary

1;

function [Case, words] = caseOf (root, folder, args)
  [~, words] = commandOptions (args, struct ());
  useLiggghts (root);
  Case = withEffects (loadCase (root, folder));
end

function status = sayReport (root, folder, args)
  Case = caseOf (root, folder, args);
  writePage (Case);
  printf ('page  %s\n', fullfile (folder, 'results', 'report.html'));
  status = 0;
end

% Not to runs.csv of the case itself: the next start would take it in.
function status = sayExport (root, folder, args)
  [Case, words] = caseOf (root, folder, args);
  file = fullfile (folder, 'results', 'runs.csv');
  if isempty (words)
    [~, ~] = mkdir (fullfile (folder, 'results'));
  else
    file = words{1};
  end
  if strcmp (make_absolute_filename (file), fullfile (folder, 'runs.csv'))
    error ('DEcalioc:sayExport:exists', ...
           ['the table cannot be %s: the next start would take it in, and ' ...
            'the runs are in the store already. Take another name.'], file);
  end
  n = exportRuns (file, Case, gatherRuns (Case));
  printf ('%d runs  %s\n', n, file);
  status = 0;
end

function status = sayCancel (root, folder, args)
  done = cancelCase (caseOf (root, folder, args));
  words = {'no Octave worked in it', 'its Octave was ended'};
  printf ('%s; %d run(s) ended here, %d job array(s) on Slurm\n', ...
          words{1 + done.octave}, done.runs, done.arrays);
  printf ('Finished runs are kept; the same command goes on.\n');
  status = 0;
end

function result = carryOut (root, folder, words)
  commands = struct ('new', @sayNew, 'check', @sayCheck, ...
                     'status', @sayStatus, 'report', @sayReport, ...
                     'export', @sayExport, 'cancel', @sayCancel, ...
                     'doctor', @sayDoctor, 'runs', @sayLibrary, ...
                     'forget', @(varargin) sayLibrary (varargin{:}, true));
  command = commands.(words{1});
  result.exitStatus = command (root, folder, words(2:end));
end

root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
addpath (fullfile (root, 'infrastructure'));
startMain (@(root, folder) carryOut (root, folder, argv ()), root);
