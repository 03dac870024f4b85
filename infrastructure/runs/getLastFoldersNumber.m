% GETLASTFOLDERSNUMBER  Highest number of a model's run folders.
%
% CALL: NUMBER = getLastFoldersNumber (PATH, MODEL)
%       NUMBER = getLastFoldersNumber (PLACE)
%
%   PATH    folder that holds optim/ (text)
%   MODEL   name of the model (text)
%   PLACE   folder of the model's runs, PATH/optim/MODEL (text)
%   NUMBER  integer, 0 where there is none yet
%
% See also: getLastFoldersName, newFolderName

function number = getLastFoldersNumber (varargin)
  [~, numbers] = listRunFolders (varargin{:});
  number = max ([0; numbers]);
end

%!assert (getLastFoldersNumber ('/nowhere', 'M'), 0)

% SPDX-License-Identifier: GPL-3.0-only
