% COMMANDMAIN  What bin/decalioc hands to Octave: one command.
%
% CALL: octave-cli commandMain.m NAME WORD...   in the folder of the case
%
% The exit status is that of the command, 1 after an error.
%
% See also: sayNew, sayCheck, sayStatus, sayExport, sayReport, sayCancel,
% sayDoctor

1;

function result = carryOut (root, folder, words)
  commands = struct ('new', @sayNew, 'check', @sayCheck, ...
                     'status', @sayStatus, 'report', @sayReport, ...
                     'export', @sayExport, 'cancel', @sayCancel, ...
                     'doctor', @sayDoctor);
  command = commands.(words{1});
  result.exitStatus = command (root, folder, words(2:end));
end

root = fileparts (fileparts (fileparts (mfilename ('fullpath'))));
addpath (fullfile (root, 'infrastructure'));
startMain (@(root, folder) carryOut (root, folder, argv ()), root);
