% LISTRUNFOLDERS  Names of the run folders of a model.
%
% CALL: NAMES = listRunFolders (BASE, MODEL)
%
%   BASE   folder that holds optim/ (text)
%   MODEL  name of the model (text)
%   NAMES  n x 1 cell of names that begin with a digit, sorted
%
% See also: findRuns, getLastFoldersName

function names = listRunFolders (base, model)
  names = readdir (fullfile (base, 'optim', model));
  if isempty (names)
    names = cell (0, 1);
    return;
  end
  isRun = cellfun (@(n) n(1) >= '0' && n(1) <= '9', names);
  names = names(isRun);
end

%!assert (size (listRunFolders ('/nowhere', 'M')), [0, 1])
