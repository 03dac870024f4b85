% STARTSIMULATION  Starts runscript in the folder of a run and waits.
%
% CALL: STATUS = startSimulation (MODEL, FOLDERNAME, BASE)
%
%   MODEL       name of the model (text)
%   FOLDERNAME  name of the run's folder (text)
%   BASE        folder that holds optim/ (text, default pwd)
%   STATUS      exit status of runscript
%
% See also: runScript, startRun

function status = startSimulation (model, folderName, base)
  if nargin < 3
    base = pwd ();
  end
  folder = fullfile (base, 'optim', model, folderName);
  here = fileparts (fileparts (mfilename ('fullpath')));
  system (sprintf ('setsid -w bash %s %s %d', ...
                   shellQuote (fullfile (here, 'process', 'guard.sh')), ...
                   shellQuote (folder), getpid ()));
  mark = readEndMark (folder);
  if isempty (mark)
    writeAtomic (fullfile (folder, 'end.mark'), "137 0.0 killed\n");
    mark.code = 137;
  end
  status = mark.code;
end

%!test
%! base = tempname ();
%! folder = fullfile (base, 'optim', 'M', '0001');
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'runscript'), "echo hello\nexit 3\n");
%! assert (startSimulation ('M', '0001', base), 3);
%! assert (fileread (fullfile (folder, 'stdout.txt')), "hello\n");

% SPDX-License-Identifier: GPL-3.0-only
