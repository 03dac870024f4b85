% GETLASTFOLDERSNAME  Name of the run folder with the highest number.
%
% CALL: NAME = getLastFoldersName (PATH, MODEL)
%
%   PATH   folder that holds optim/ (text)
%   MODEL  name of the model (text)
%   NAME   text, '' where there is none yet
%
% See also: getLastFoldersNumber

function name = getLastFoldersName (path, model)
  [names, numbers] = listRunFolders (path, model);
  [~, last] = max (numbers);
  name = [names{last}, ''];
end

%!test
%! base = tempname ();
%! assert (getLastFoldersName (base, 'M'), '');
%! for name = {'0009', '0010x_3', '9999', '10000', 'notes'}
%!   mkdir (fullfile (base, 'optim', 'M', name{1}));
%! end
%! assert (getLastFoldersName (base, 'M'), '10000');
%! assert (getLastFoldersNumber (base, 'M'), 10000);

% SPDX-License-Identifier: GPL-3.0-only
