% STARTCOMMAND  Calls the command decalioc as a user does, through a link.
%
% CALL: [STATUS, OUT] = startCommand (FOLDER, WORDS)
%
%   FOLDER  folder to start in (text); the link lies below it, in "my bin"
%   WORDS   what stands behind decalioc (text, quoted for the shell)
%   STATUS  exit status
%   OUT     what came on both streams (text)
%
% See also: startProgram

function [status, out] = startCommand (folder, words)
  root = fileparts (fileparts (mfilename ('fullpath')));
  place = fullfile (folder, 'my bin');
  [~, ~] = mkdir (place);
  link = fullfile (place, 'decalioc');
  if isempty (lstat (link))
    symlink (fullfile (root, 'bin', 'decalioc'), link);
  end
  command = sprintf ('cd %s && %s %s 2>&1 < /dev/null', ...
                     shellQuote (folder), shellQuote (link), words);
  [status, out] = system (command);
end

% SPDX-License-Identifier: GPL-3.0-only
