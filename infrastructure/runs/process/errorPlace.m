% ERRORPLACE  Where an error arose, as the user's own files go.
%
% CALL: TEXT = errorPlace (ERR, FOLDER)
%
%   ERR     error, as catch gives it
%   FOLDER  folder of the user's functions (text); part of the path will do
%   TEXT    ' (getResults.m, line 7)', of the innermost of these functions; ''
%           where none is among the callers

function text = errorPlace (err, folder)
  text = '';
  inside = strfind ({err.stack.file}, folder);
  k = find (~cellfun (@isempty, inside), 1);
  if ~isempty (k)
    [~, base, ending] = fileparts (err.stack(k).file);
    text = sprintf (' (%s%s, line %d)', base, ending, err.stack(k).line);
  end
end

%!test
%! file = @(name) struct ('file', name, 'name', 'f', 'line', 7, 'column', 1);
%! err = struct ('stack', [file('/a/b/x.m'), file('/a/OctaveFuns/y.m'), ...
%!                         file('/a/OctaveFuns/getResults.m')]);
%! assert (errorPlace (err, 'OctaveFuns'), ' (y.m, line 7)');
%! assert (errorPlace (err, 'elsewhere'), '');

% SPDX-License-Identifier: GPL-3.0-only
