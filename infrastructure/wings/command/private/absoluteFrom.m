% ABSOLUTEFROM  Path of a file that was named in a folder.
%
% CALL: PATH = absoluteFrom (FOLDER, NAME)
%
%   FOLDER  the folder in which the user stood (text; '': the current one)
%   NAME    as the user typed it; ~ is the home folder

function path = absoluteFrom (folder, name)
  path = tilde_expand (name);
  if isempty (path) || path(1) ~= '/'
    path = fullfile (folder, path);
  end
  path = make_absolute_filename (path);
  % of an absolute name the steps upwards stay in it
  steps = '';
  while ~strcmp (path, steps)
    steps = path;
    path = regexprep (path, '/(?!\.\./)[^/]+/\.\.(/|$)', '/', 'once');
  end
  path = regexprep (path, '(.)/$', '$1');
end

%!assert (absoluteFrom ('/a', 'b/../c'), '/a/c')
%!assert (absoluteFrom ('/a/b', '../../c/'), '/c')
%!assert (absoluteFrom ('/a', '/b'), '/b')
%!assert (absoluteFrom ('/a', ''), '/a')
%!assert (absoluteFrom ('', 'b'), fullfile (pwd (), 'b'))
%!assert (absoluteFrom ('/a', '~'), tilde_expand ('~'))

% SPDX-License-Identifier: GPL-3.0-only
