% LISTRUNFOLDERS  Names and numbers of the run folders of a model.
%
% CALL: [NAMES, NUMBERS] = listRunFolders (PLACE)
%       [NAMES, NUMBERS] = listRunFolders (BASE, MODEL)
%
%   PLACE    folder of the model's runs, BASE/optim/MODEL (text), see runPlace
%   BASE     folder that holds optim/ (text)
%   MODEL    name of the model (text)
%   NAMES    n x 1 cell of names that begin with a digit, sorted
%   NUMBERS  n x 1, with which they begin

function [names, numbers] = listRunFolders (place, model)
  if nargin > 1
    place = fullfile (place, 'optim', model);
  end
  names = readdir (place);
  if isempty (names)
    names = cell (0, 1);
  else
    names = names(isdigit (char (names)(:, 1)));   % fast with 100,000
  end
  if nargout > 1
    numbers = str2double (regexp (names, '^\d+', 'match', 'once'));
  end
end

%!test
%! [names, numbers] = listRunFolders ('/nowhere', 'M');
%! assert (size (names), [0, 1]);
%! assert (isempty (numbers));

% SPDX-License-Identifier: GPL-3.0-only
