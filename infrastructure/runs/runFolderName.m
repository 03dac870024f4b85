% RUNFOLDERNAME  Name of the folder of a run.
%
% CALL: name = runFolderName (number)
%
% number  number of the run (1, 2, ...)
% name    text, at least four digits
%
% See also: lastRunFolder, prepareRun, newFolderName

function name = runFolderName (number)
  name = sprintf ('%04d', number);
end

%!assert (runFolderName (7), '0007')
%!assert (runFolderName (12345), '12345')
