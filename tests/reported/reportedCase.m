% REPORTEDCASE  A copy of a case that a user reported, in a new folder.
%
% CALL: FOLDER = reportedCase (NAME)
%
%   NAME    a folder beside this file, named after its fault (text)
%   FOLDER  the copy (text), which the caller may change and run
%
% Each flow tests/reported/NAME.tst says what is right there now.
%
% See also: startCommand

function folder = reportedCase (name)
  source = fullfile (fileparts (mfilename ('fullpath')), name);
  folder = tempname ();
  [ok, why] = copyfile (source, folder);
  if ~ok
    error ('DEcalioc:reportedCase:missingFile', ...
           'reportedCase: %s must be a folder that can be copied, got: %s', ...
           source, why);
  end
end
