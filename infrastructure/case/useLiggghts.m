% USELIGGGHTS  Puts the folder of the chosen LIGGGHTS first in PATH.
%
% CALL: useLiggghts (ROOT)
%
%   ROOT  folder of the toolbox (text)
%
% The choice is that of tools/liggghts/path.sh: the build of this toolbox, or
% what the environment variable LIGGGHTS says. Where neither is there, PATH
% stays as it is; a case whose models need no LIGGGHTS runs all the same.

function useLiggghts (root)
  script = fullfile (root, 'tools', 'liggghts', 'path.sh');
  [status, folder] = system (['bash ', shellQuote(script), ' 2> /dev/null']);
  folder = strtrim (folder);
  if status == 0 && ~strncmp (getenv ('PATH'), [folder, ':'], ...
                              numel (folder) + 1)
    setenv ('PATH', [folder, ':', getenv('PATH')]);
  end
end

%!test
%! before = getenv ('PATH');
%! useLiggghts ('/nowhere');
%! assert (getenv ('PATH'), before);
