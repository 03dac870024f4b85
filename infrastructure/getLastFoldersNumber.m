% GETLASTFOLDERSNUMBER  Highest number of a model's run folders.
%
% CALL: NUMBER = getLastFoldersNumber (PATH, MODEL)
%
%   PATH    folder that holds optim/ (text)
%   MODEL   name of the model (text)
%   NUMBER  integer, 0 where there is none yet
%
% See also: getLastFoldersName, newFolderName

function number = getLastFoldersNumber (path, model)
  [~, numbers] = listRunFolders (path, model);
  number = max ([0; numbers]);
end

%!assert (getLastFoldersNumber ('/nowhere', 'M'), 0)
