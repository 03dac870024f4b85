% RUNFOLDERNAME  Name of the folder of a run.
%
% CALL: NAME = runFolderName (NUMBER)
%
% NUMBER  number of the run (1, 2, ...)
% NAME    text, at least four digits
%
% See also: lastRunFolder, prepareRun, newFolderName

function name = runFolderName (number)
  name = sprintf ('%04d', number);
end

%!assert (runFolderName (7), '0007')
%!assert (runFolderName (12345), '12345')
