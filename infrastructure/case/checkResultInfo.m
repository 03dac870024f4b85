% CHECKRESULTINFO  What results.csv of a model says, as far as it can be read.
%
% CALL: INFO = checkResultInfo (FOLDER)
%
%   FOLDER  model folder ('': none)
%   INFO    see resultInfo; 1 x 0 without a table, or one that cannot be read

function info = checkResultInfo (folder)
  info = struct ('name', cell (1, 0), 'kind', '', 'unit', '', 'series', '');
  try
    found = resultInfo (folder);
    if ~isempty (found)
      info = found;
    end
  catch
    % said elsewhere
  end
end

%!assert (size (checkResultInfo ('')), [1, 0])

% SPDX-License-Identifier: GPL-3.0-only
