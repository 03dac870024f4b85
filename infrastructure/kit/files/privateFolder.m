% PRIVATEFOLDER  Makes a new folder that its owner alone may use.
%
% CALL: FOLDER = privateFolder ()
%       FOLDER = privateFolder (FOLDER)
%
%   FOLDER  path (text); without one a new name in the folder of temporary
%           files (TMPDIR, else /tmp)
%
% Nothing that was there already is taken: somebody else could have made it.
%
% Errors: DEcalioc:privateFolder:cannotWrite

function folder = privateFolder (folder)
  if nargin < 1
    folder = draftName (fullfile (tempdir (), 'decalioc'))(1:end - 4);
  end
  before = umask (77);
  [made, why] = mkdir (folder);
  umask (before);
  if ~made || ~isempty (why)
    error ('DEcalioc:privateFolder:cannotWrite', ...
           ['privateFolder: %s must be a new folder, got: %s. Free some ' ...
            'space (for temporary files: or set TMPDIR to a folder on ' ...
            'another disk) and start again; finished runs are kept.'], ...
           folder, why);
  end
end

%!test
%! folder = privateFolder ();
%! assert (strncmp (stat (folder).modestr, 'drwx------', 10));
%! inside = privateFolder (fullfile (folder, 'a'));
%! writeAtomic (fullfile (folder, 'b'), '');
%! assert (stat (fullfile (folder, 'b')).modestr(1:4), '-rw-');
%!error id=DEcalioc:privateFolder:cannotWrite privateFolder (tempdir ())
%!error id=DEcalioc:privateFolder:cannotWrite privateFolder ('/proc/x')

% SPDX-License-Identifier: GPL-3.0-only
