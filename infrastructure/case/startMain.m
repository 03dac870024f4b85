% STARTMAIN  Carries out a main script: its folder, its errors, its status.
%
% CALL: RESULT = startMain (JOB, ROOT)
%
%   JOB     function handle: RESULT = JOB (ROOT, FOLDER)
%   ROOT    folder of the toolbox (text)
%   RESULT  struct with the field exitStatus (0 or 2)
%
% Where Octave was started with the script as its program (octave-cli
% DEcalioc.m), it is left with the exit status of the result, or with 1 and
% the message alone after an error. At the prompt, errors are errors.
%
% See also: DEcalioc, diagnoseGap

function result = startMain (job, root)
  more ('off');
  folder = caseFolder (root);
  if ~strcmp (folder, pwd ())
    cd (folder);
  end
  isProgram = numel (program_name ()) > 2 && ...
              strcmp (program_name ()(end - 1:end), '.m');
  try
    result = job (root, folder);
  catch err
    if ~isProgram || ~strncmp (err.identifier, 'DEcalioc:', 9)
      rethrow (err);
    end
    fprintf (stderr (), '%s\n', err.message);
    exit (1);
  end
  if isProgram
    exit (result.exitStatus);
  end
end
