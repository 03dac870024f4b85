% LISTRUNFOLDERS  Names of the run folders of a model.
%
% CALL: NAMES = listRunFolders (BASE, MODEL)
%
%   BASE   folder that holds optim/ (text)
%   MODEL  name of the model (text)
%   NAMES  n x 1 cell of names that begin with a digit, sorted

function names = listRunFolders (base, model)
  names = readdir (fullfile (base, 'optim', model));
  if isempty (names)
    names = cell (0, 1);
    return
  end
  names = names(~cellfun ('isempty', regexp (names, '^[0-9]', 'once')));
end

%!assert (size (listRunFolders ('/nowhere', 'M')), [0, 1])
