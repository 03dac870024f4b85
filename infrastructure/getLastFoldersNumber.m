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
  name = getLastFoldersName (path, model);
  number = 0;
  if ~isempty (name)
    number = str2double (regexp (name, '^\d+', 'match', 'once'));
  end
end

%!assert (getLastFoldersNumber ('/nowhere', 'M'), 0)
