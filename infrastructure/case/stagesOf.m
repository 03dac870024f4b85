% STAGESOF  Models from whose last state the runs of a model start.
%
% CALL: [NAMES, FOLDERS] = stagesOf (FOLDER)
%       [NAMES, FOLDERS] = stagesOf (FOLDER, 'all')   and those that these start from
%
%   FOLDER   model folder (text); '' has none
%   NAMES    1 x n cell of the names in its file startsFrom, one a line; what
%            stands behind # is a remark
%   FOLDERS  1 x n cell of their folders, which lie beside it
%
% A run of the model finds that of the stage with the same values and the same
% packing as a folder of its name: read_restart Fill/filled.restart.
%
% See also: withStages, runJobs

function [names, folders] = stagesOf (folder, varargin)
  names = cell (1, 0);
  file = fullfile (folder, 'startsFrom');
  if ~isempty (folder) && isfile (file)
    text = regexprep (checkReadText (file), '#[^\n]*', '');
    names = unique (regexp (text, '[^\s]+', 'match'));
  end
  folders = cell (1, numel (names));
  for k = 1:numel (names)
    folders{k} = fullfile (fileparts (folder), names{k});
  end
  k = 0;
  while k < numel (folders) * ~isempty (varargin)
    k = k + 1;
    [others, places] = stagesOf (folders{k});
    isNew = ~ismember (places, folders);
    [names, folders] = deal ([names, others(isNew)], [folders, places(isNew)]);
  end
end

%!test
%! folder = fullfile (tempname (), 'DEMmodels', 'Tap');
%! mkdir (folder);
%! assert (stagesOf (folder), cell (1, 0));
%! writeAtomic (fullfile (folder, 'startsFrom'), "Fill  # loose\r\n\nWet\n");
%! [names, folders] = stagesOf (folder);
%! assert (names, {'Fill', 'Wet'});
%! assert (folders{2}, fullfile (fileparts (folder), 'Wet'));
%! % all, also in a circle
%! mkdir (folders{1});
%! writeAtomic (fullfile (folders{1}, 'startsFrom'), "Tap\nWet");
%! assert (stagesOf (folder, 'all'), {'Fill', 'Wet', 'Tap'});
%!assert (stagesOf (''), cell (1, 0))

% SPDX-License-Identifier: GPL-3.0-only
