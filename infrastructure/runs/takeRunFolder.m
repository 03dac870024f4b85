% TAKERUNFOLDER  Takes the next free folder for a run of a model.
%
% CALL: [FOLDER, NUMBER] = takeRunFolder (STORE, MODEL, NUMBER)
%
%   STORE   folder that holds optim/ (text)
%   MODEL   name of the model (text)
%   NUMBER  number that is tried first (default: one above the last); NUMBER
%           returned is the one that was free
%   FOLDER  path of the folder, which is there now and empty

function [folder, number] = takeRunFolder (store, model, number)
  if nargin < 3
    [~, numbers] = listRunFolders (store, model);
    number = max ([0; numbers]) + 1;
  end
  folder = '';
  while isempty (folder)
    folder = fullfile (store, 'optim', model, sprintf ('%04d', number));
    if ~makeRunFolder (folder)
      folder = '';
      number = number + 1;
    end
  end
end

%!test
%! store = tempname ();
%! [folder, number] = takeRunFolder (store, 'M');
%! assert (folder, fullfile (store, 'optim', 'M', newFolderName (1)));
%! assert (isfolder (folder));
%! [~, number] = takeRunFolder (store, 'M', number);
%! assert (number, 2);
