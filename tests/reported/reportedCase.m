% REPORTEDCASE  A copy of a case that a user reported, in a new folder.
%
% CALL: FOLDER = reportedCase (NAME [, BASE])
%
%   NAME    a folder beside this file, named after its fault (text)
%   BASE    one that several share, below what NAME has itself (text)
%   FOLDER  the copy (text), which the caller may change and run
%
% Each flow tests/reported/NAME.tst says what is right there now.
%
% See also: startCommand

function folder = reportedCase (name, base)
  folder = tempname ();
  mkdir (folder);
  names = {name};
  if nargin > 1
    names = {base, name};
  end
  for part = names
    source = fullfile (fileparts (mfilename ('fullpath')), part{1});
    [ok, why] = copyfile (fullfile (source, '*'), folder);
    if ~ok
      error ('DEcalioc:reportedCase:missingFile', ...
             'reportedCase: %s must be a folder that can be copied, got: %s', ...
             source, why);
    end
  end
end

% SPDX-License-Identifier: GPL-3.0-only
