% STARTPROGRAM  Starts a main script in a fresh Octave, as a user does.
%
% CALL: [STATUS, OUT, ERR] = startProgram (FOLDER, WORDS)
%
%   FOLDER  folder to start in (text)
%   WORDS   arguments of octave-cli (text; default: DEcalioc.m of the toolbox)
%   STATUS  exit status; OUT, ERR  what came on the two streams (text)
%
% HOME is an empty folder, as on a new machine.
%
% See also: standInCase

function [status, out, err] = startProgram (folder, words)
  root = fileparts (fileparts (mfilename ('fullpath')));
  if nargin < 2
    words = shellQuote (fullfile (root, 'DEcalioc.m'));
  end
  home = tempname ();
  mkdir (home);
  streams = {fullfile(home, 'out'), fullfile(home, 'err')};
  status = system (sprintf (['cd %s && HOME=%s octave-cli %s > %s 2> %s ' ...
                             '< /dev/null'], shellQuote (folder), ...
                            shellQuote (home), words, ...
                            shellQuote (streams{1}), shellQuote (streams{2})));
  out = fileread (streams{1});
  err = fileread (streams{2});
  if isempty (err)
    err = '';
  end
  confirm_recursive_rmdir (false, 'local');
  rmdir (home, 's');
end

% SPDX-License-Identifier: GPL-3.0-only
