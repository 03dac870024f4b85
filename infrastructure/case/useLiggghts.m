% USELIGGGHTS  Puts the folder of the chosen LIGGGHTS first in PATH.
%
% CALL: useLiggghts (ROOT)
%       CHOICE = useLiggghts (ROOT)
%
%   ROOT    folder of the toolbox (text)
%   CHOICE  scalar struct of texts: program (path, '' where there is none),
%           version ('' where it does not say), why, how (to choose another)
%
% The choice is that of tools/liggghts/path.sh: the build of this toolbox, or
% what the environment variable LIGGGHTS says. Where neither is there, PATH
% stays as it is; a case whose models need no LIGGGHTS runs all the same.

function choice = useLiggghts (root)
  if nargout > 0
    before = onPath ();
  end
  script = fullfile (root, 'tools', 'liggghts', 'path.sh');
  [status, folder] = system (['bash ', shellQuote(script), ' 2> /dev/null']);
  folder = strtrim (folder);
  if status == 0 && ~strncmp (getenv ('PATH'), [folder, ':'], ...
                              numel (folder) + 1)
    setenv ('PATH', [folder, ':', getenv('PATH')]);
  end
  if nargout > 0
    choice = describe (root, before);
  end
end

function choice = describe (root, before)
  choice.program = onPath ();
  choice.version = versionOf (choice.program);
  wish = getenv ('LIGGGHTS');
  choice.how = ['another one: LIGGGHTS=/path/to/liggghts, or ' ...
                'LIGGGHTS=system for the one on the PATH, before the command'];
  if ~isempty (wish)
    choice.why = ['the environment says LIGGGHTS=', wish];
    choice.how = 'the toolbox''s own: unset LIGGGHTS';
  elseif isempty (choice.program)
    choice.why = 'none is on the PATH, and the toolbox has built none';
    choice.how = sprintf (['build one, once: make -C %s setup liggghts; ' ...
                           'or set LIGGGHTS=/path/to/liggghts'], ...
                          shellQuote (root));
  elseif strcmp (choice.program, before)
    choice.why = ['it is the first on the PATH, and the toolbox has built ' ...
                  'none'];
    choice.how = sprintf ('build the toolbox''s own: make -C %s liggghts', ...
                          shellQuote (root));
  else
    choice.why = 'built by this toolbox';
    if ~isempty (before)
      choice.why = [choice.why, '; it goes before ', before, ' on the PATH'];
    end
  end
end

function program = onPath ()
  [status, text] = system ('readlink -f "$(command -v liggghts)" 2> /dev/null');
  program = strtrim (text(1:end * (status == 0)));
end

function text = versionOf (program)
  text = '';
  if ~isempty (program)
    [~, answer] = system (['cd "${TMPDIR:-/tmp}" && timeout 20 ', ...
                           shellQuote(program), ...
                           ' -log none < /dev/null 2> /dev/null']);
    found = regexp (answer, 'LIGGGHTS[^\n()]*\(Version ([^),]*)', 'tokens', ...
                    'once');
    text = strjoin ([found, {''}], '');
  end
end

%!shared root
%! root = fileparts (fileparts (which ('startToolbox')));
%!test
%! before = getenv ('PATH');
%! useLiggghts ('/nowhere');
%! assert (getenv ('PATH'), before);
%!function choice = withEnvironment (root, path, wish, cache)
%!  before = {getenv('PATH'), getenv('LIGGGHTS'), getenv('XDG_CACHE_HOME')};
%!  names = {'PATH', 'LIGGGHTS', 'XDG_CACHE_HOME'};
%!  cellfun (@setenv, names, {[path, getenv('PATH')], wish, cache});
%!  choice = useLiggghts (root);
%!  cellfun (@setenv, names, before);
%!endfunction
%!function place = fakeProgram ()
%!  place = emptyFolder ();
%!  file = fullfile (place, 'liggghts');
%!  writeAtomic (file, ["#!/bin/sh\necho 'LIGGGHTS (Version FAKE-1.2, ", ...
%!                      "compiled now)'\n"]);
%!  system (['chmod +x ', shellQuote(file)]);
%!endfunction
%!test
%! % nothing built: the first on the PATH; then the one that LIGGGHTS names
%! place = fakeProgram ();
%! none = tempname ();
%! choice = withEnvironment (root, [place, ':'], '', none);
%! assert (choice.program, fullfile (place, 'liggghts'));
%! assert (choice.version, 'FAKE-1.2');
%! assert (~isempty (strfind (choice.why, 'the first on the PATH')));
%! choice = withEnvironment (root, '', fullfile (place, 'liggghts'), none);
%! assert (choice.program, fullfile (place, 'liggghts'));
%! assert (~isempty (strfind (choice.why, 'LIGGGHTS=')));
%!testif ; isfolder (fullfile (getenv ('HOME'), '.cache', 'decalioc'))
%! % the toolbox's own goes before the one on the PATH, and says so
%! [status, own] = system (['LIGGGHTS= bash ', shellQuote(fullfile (root, ...
%!                          'tools', 'liggghts', 'path.sh')), ' 2> /dev/null']);
%! if status == 0
%!   place = fakeProgram ();
%!   choice = withEnvironment (root, [place, ':'], '', ...
%!                             getenv ('XDG_CACHE_HOME'));
%!   assert (choice.program, fullfile (strtrim (own), 'liggghts'));
%!   assert (~isempty (strfind (choice.why, place)));
%! end

% SPDX-License-Identifier: GPL-3.0-only
