% NEWFOLDERNAME  Name of the folder of a run.
%
% CALL: NAME = newFolderName (NUM)
%
%   NUM   number of the run (1, 2, ...)
%   NAME  text, at least four digits
%
% See also: createNewFolder, getLastFoldersNumber

function name = newFolderName (num)
  name = sprintf ('%04d', num);
end

%!assert (newFolderName (7), '0007')
%!assert (newFolderName (12345), '12345')

% SPDX-License-Identifier: GPL-3.0-only
