% STARTMAIN  Carries out a main script: path, folder, errors, exit status.
%
% CALL: RESULT = startMain (JOB, ROOT)
%
%   JOB     function handle: RESULT = JOB (ROOT, FOLDER)
%   ROOT    folder of the toolbox (text)
%   RESULT  struct with the field exitStatus (0 or 2)
%
% FOLDER is the folder Octave works in; only where Octave's own command run has
% moved to ROOT, the folder Octave was started in, if that holds a loadInput.m.
%
% Where the script that calls this is the program of Octave itself (octave-cli
% DEcalioc.m), Octave is left with the exit status of the result, or with 1 and
% the message alone after an error. At the prompt and in a script of the user's
% errors are errors, and what stands behind the call is reached. The case's
% folder is off the path again afterwards, so that the next case in the same
% Octave finds none of its functions.
%
% See also: DEcalioc, diagnoseGap, startToolbox

function result = startMain (job, root)
  more ('off');
  folder = caseFolder (root);
  if ~strcmp (folder, pwd ())
    cd (folder);
  end
  stack = dbstack ('-completenames');
  isProgram = numel (stack) > 1 && isProgramOfOctave (stack(2).file);
  if ~any (strcmp (folder, strsplit (path (), pathsep ())))
    tidy = onCleanup (@() leavePath (folder));
  end
  try
    startToolbox (root, folder);
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

function folder = caseFolder (root)
  folder = pwd ();
  wasMoved = any (strcmp ({dbstack().name}, 'run')) && strcmp (folder, root);
  start = getenv ('PWD');
  if wasMoved && isfile (fullfile (start, 'loadInput.m'))
    folder = start;
  end
end

% The name that Octave was started with is relative to the folder it was
% started in; a script of the user's may be anywhere by now, and is then not
% found here, which is as well.
function yes = isProgramOfOctave (script)
  program = canonicalize_file_name (program_invocation_name ());
  yes = ischar (program) && strcmp (program, canonicalize_file_name (script));
end

% From elsewhere, as Octave does not take its own folder off the path.
function leavePath (folder)
  if any (strcmp (folder, strsplit (path (), pathsep ())))
    here = cd (fileparts (mfilename ('fullpath')));
    rmpath (folder);
    cd (here);
  end
end

%!test
%! % for a case the folder it is started in, which is off the path afterwards
%! folder = emptyFolder ();
%! here = cd (folder);
%! root = fileparts (fileparts (which ('startMain')));
%! result = startMain (@(root, folder) struct ('said', [root, folder]), root);
%! cd (here);
%! assert (result.said, [root, folder]);
%! assert (! any (strcmp (folder, strsplit (path (), pathsep ()))));
%!test
%! % without a warning in the folder of temporary files, too
%! lastwarn ('');
%! here = cd (tempdir ());
%! root = fileparts (fileparts (which ('startMain')));
%! startMain (@(root, folder) struct ('said', ''), root);
%! cd (here);
%! assert (lastwarn (), '');
%!error id=DEcalioc:a:b
%! startMain (@(root, folder) error ('DEcalioc:a:b', 'c'), ...
%!            fileparts (fileparts (which ('startMain'))));

% SPDX-License-Identifier: GPL-3.0-only
