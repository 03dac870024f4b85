% The Octave package: made twice it is the same file; installed in a scratch
% prefix, its commands work. The container recipe names files that are there.

%!shared root, work
%! root = fileparts (fileparts (which ('startProgram')));
%! work = tempname ();
%! mkdir (work);

%!function text = field (file, name)
%!  text = regexp (fileread (file), ['^', name, ': (.*)$'], 'tokens', ...
%!                 'once', 'lineanchors', 'dotexceptnewline'){1};
%!endfunction

%!test
%! % of the files as they are, in a copy: the clone's own dist/ stays as it is
%! copy = fullfile (work, 'a copy');
%! [status, out] = system (sprintf (['cd %s && mkdir %s && ' ...
%!   '{ git ls-files -z 2> /dev/null || find . -type f -print0; } | ' ...
%!   'tar -c --null --files-from=- | tar -x -C %s && ' ...
%!   'make -s -C %s dist && cd %s && sha256sum dist/* && rm -r dist && ' ...
%!   'make -s dist > /dev/null && sha256sum dist/*'], shellQuote (root), ...
%!   shellQuote (copy), shellQuote (copy), shellQuote (copy), ...
%!   shellQuote (copy)));
%! assert (status == 0, out);
%! keys = regexp (out, '^\w{64}', 'match', 'lineanchors');
%! assert (numel (keys), 2);
%! assert (keys{1}, keys{2});
%! version = strtrim (fileread (fullfile (root, 'VERSION')));
%! file = fullfile (copy, 'dist', ['decalioc-', version, '.tar.gz']);
%! prefix = fullfile (work, 'prefix');
%! mkdir (prefix);
%! writeAtomic (fullfile (work, 'install.m'), ...
%!   sprintf (["pkg prefix %s %s\npkg local_list %s\n", ...
%!             "warning off\npkg ('install', '-local', '%s');\n", ...
%!             "p = pkg ('list', 'decalioc');\nputs (p{1}.dir);\n", ...
%!             "pkg load decalioc\nputs (\"\\n\"); ", ...
%!             "puts (which ('DEcalioc'));\n"], prefix, prefix, ...
%!            fullfile (prefix, 'list'), file));
%! [status, out] = startProgram (work, '--no-history --norc install.m');
%! assert (status, 0);
%! lines = strsplit (strtrim (out), "\n");
%! place = fullfile (prefix, ['decalioc-', version]);
%! assert (lines{end - 1}, place);
%! assert (lines{end}, fullfile (place, 'DEcalioc.m'));
%! assert (field (fullfile (place, 'packinfo', 'DESCRIPTION'), 'Version'), ...
%!         version);
%! % the installed command makes a case, checks and runs it
%! case_ = fullfile (work, 'case');
%! standInCase (case_);
%! writeLoadInput (case_, 'optim.maxFunEvals = 8; Input.replicates = 1;');
%! program = shellQuote (fullfile (place, 'bin', 'decalioc'));
%! call = @(words) system (sprintf ('cd %s && %s %s 2>&1 < /dev/null', ...
%!                                  shellQuote (work), program, words));
%! [status, out] = call ('--version');
%! assert (strtrim (out), ['decalioc ', version]);
%! [status, out] = call ('new --model Mine');
%! assert (status == 0, out);
%! assert (isfile (fullfile (work, 'Mine', 'DEMmodels', 'Mine', 'effects', ...
%!                           'material.inc')));
%! [status, out] = call ('check Mine');
%! if ~isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%!   assert (status == 0, out);
%! end
%! [status, out] = call ('run case');
%! assert (any (status == [0, 2]), out);
%! assert (isfile (fullfile (case_, 'results', 'calibration.json')));

%!test
%! % one version: no other file says another one
%! version = strtrim (fileread (fullfile (root, 'VERSION')));
%! assert (~isempty (regexp (version, '^\d+\.\d+\.\d+$', 'once')));
%! text = fileread (fullfile (root, 'CHANGELOG.md'));
%! first = regexp (text, '^## (\S+) \(', 'tokens', 'once', 'lineanchors'){1};
%! assert (first, version);
%! text = fileread (fullfile (root, 'docs', 'install.md'));
%! named = regexp (text, 'decalioc-([\d.]+)\.tar', 'tokens');
%! assert (unique ([named{:}]), {version});

%!test
%! % what the container copies and calls is there and can be started
%! text = fileread (fullfile (root, 'Containerfile'));
%! called = regexp (text, '/opt/decalioc/(\S+)', 'tokens');
%! names = unique ([called{:}]);
%! assert (numel (names) >= 4);
%! for name = names
%!   assert (exist (fullfile (root, name{1})) > 0, name{1});
%! end
%! % nothing runs as root
%! users = regexp (text, '^USER (\w+)', 'tokens', 'lineanchors');
%! assert (! isempty (users) && ! strcmp (users{end}{1}, 'root'));
%! % what the recipe leaves out is not what the toolbox needs
%! text = fileread (fullfile (root, '.containerignore'));
%! left = strsplit (strtrim (text), "\n");
%! needed = {'bin', 'infrastructure', 'templates', 'tools', 'DEMmodels'};
%! for name = needed
%!   assert (~any (strcmp (left, ['/', name{1}])));
%! end
%! assert (all (cellfun (@(l) any (l(1) == './!'), left)));

%!test
%! % what comes from PyPI is known to the last bit
%! for tool = {'lint', 'axe'}
%!   script = fileread (fullfile (root, 'tools', [tool{1}, '.sh']));
%!   list = ['requirements-', tool{1}, '.txt'];
%!   calls = regexp (script, 'pip" install[^;&}]*', 'match');
%!   assert (numel (calls), 1);
%!   assert (! isempty (strfind (calls{1}, '--require-hashes')));
%!   assert (! isempty (strfind (calls{1}, list)));
%!   lines = strsplit (strtrim (fileread (fullfile (root, 'tools', list))), ...
%!                     "\n")(2:end);
%!   assert (! isempty (lines));
%!   isPinned = regexp (lines, '^[\w-]+==[\d.]+ --hash=sha256:[0-9a-f]{64}$');
%!   assert (! any (cellfun (@isempty, isPinned)));
%! end

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (work, 's');

% SPDX-License-Identifier: GPL-3.0-only
