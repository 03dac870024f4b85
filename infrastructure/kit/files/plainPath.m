% PLAINPATH  A full path without . and .., whether it is there or not.
%
% CALL: PATH = plainPath (PATH)
%
%   PATH  text that begins with a slash

function path = plainPath (path)
  if isempty (regexp (path, '/\.{0,2}(/|$)', 'once'))
    return                             % most are plain already
  end
  parts = strsplit (path, '/');
  kept = cell (1, 0);
  for part = parts
    if strcmp (part{1}, '..')
      kept = kept(1:end - 1);
    elseif ~any (strcmp (part{1}, {'', '.'}))
      kept(end + 1) = part;
    end
  end
  path = ['/', strjoin(kept, '/')];
end

%!assert (plainPath ('/a/./b/../c//d'), '/a/c/d')
%!assert (plainPath ('/..'), '/')
%!assert (plainPath ('/a/.b/c..d'), '/a/.b/c..d')
%!assert (plainPath ('/a/'), '/a')

% SPDX-License-Identifier: GPL-3.0-only
