% TOOLBOXVERSION  Which version of the toolbox this is.
%
% CALL: TEXT = toolboxVersion (ROOT)
%
%   ROOT  folder of the toolbox (text)
%   TEXT  what its file VERSION says, if there is one, and the commit, if
%         it is a clone; 'unknown' without either

function text = toolboxVersion (root)
  parts = {};
  file = fullfile (root, 'VERSION');
  if isfile (file)
    parts{end + 1} = strtrim (fileread (file));
  end
  if exist (fullfile (root, '.git'), 'file')
    [status, commit] = system (['git -C ', shellQuote(root), ...
                                ' rev-parse --short HEAD 2> /dev/null']);
    if status == 0
      parts{end + 1} = ['commit ', strtrim(commit)];
    end
  end
  text = strjoin (parts, ', ');
  if isempty (text)
    text = 'unknown';
  end
end

%!test
%! folder = emptyFolder ();
%! assert (toolboxVersion (folder), 'unknown');
%! writeAtomic (fullfile (folder, 'VERSION'), "2.1.0\n");
%! assert (toolboxVersion (folder), '2.1.0');

% SPDX-License-Identifier: GPL-3.0-only
