% TAKERUNFOLDER  Takes the next free folder for a run of a model.
%
% CALL: [FOLDER, NUMBER] = takeRunFolder (PLACE, NUMBER)
%
%   PLACE   folder of the model's runs, see runPlace
%   NUMBER  number that is tried first (default: one above the last); NUMBER
%           returned is the one that was free
%   FOLDER  path of the folder, which is there now and empty

function [folder, number] = takeRunFolder (place, number)
  if nargin < 2
    [~, numbers] = listRunFolders (place);
    number = max ([0; numbers]) + 1;
  end
  folder = '';
  while isempty (folder)
    folder = fullfile (place, sprintf ('%04d', number));
    if ~makeRunFolder (folder)
      folder = '';
      number = number + 1;
    end
  end
end

%!test
%! place = fullfile (tempname (), 'optim', 'M');
%! [folder, number] = takeRunFolder (place);
%! assert (folder, fullfile (place, newFolderName (1)));
%! assert (isfolder (folder));
%! [~, number] = takeRunFolder (place, number);
%! assert (number, 2);

% SPDX-License-Identifier: GPL-3.0-only
