% EMPTYFOLDER  Makes an empty folder for a test.
%
% CALL: [FOLDER, PUT] = emptyFolder ()
%
%   FOLDER  its path (text), below TMPDIR
%   PUT     handle: PUT (NAME, TEXT) writes a file there
%
% See also: standInCase

function [folder, put] = emptyFolder ()
  folder = tempname ();
  mkdir (folder);
  put = @(name, text) writeAtomic (fullfile (folder, name), text);
end

% SPDX-License-Identifier: GPL-3.0-only
