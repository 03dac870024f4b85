% A release (tools/release.sh) and the lines of the licence (tools/spdx.sh), in a clone.

%!function [status, out] = in (folder, command)
%!  [status, out] = system (sprintf ('cd %s && %s 2>&1', shellQuote (folder), command));
%!endfunction

%!function copy = cloneOf ()
%!  root = fileparts (fileparts (which ('startProgram')));
%!  copy = emptyFolder ();
%!  [status, out] = in (root, ['{ git ls-files -z 2> /dev/null || ', ...
%!    'find . -type f -print0; } | tar -c --null --files-from=- | tar -x -C ', ...
%!    shellQuote(copy)]);
%!  assert (status == 0, out);
%!  commit (copy);
%!endfunction

%!function commit (folder)
%!  [status, out] = in (folder, ['git -c init.defaultBranch=main init -q && git add -A && ', ...
%!                               'git -c user.name=a -c user.email=a@b commit -q -m a']);
%!  assert (status == 0, out);
%!endfunction

%!function copy = withNews (copy)
%! % a tree that has just been released says nothing of what comes after it
%!  file = fullfile (copy, 'CHANGELOG.md');
%!  text = fileread (file);
%!  news = ['## After ', strtrim(fileread (fullfile (copy, 'VERSION')))];
%!  if isempty (strfind (text, [news, "\n"]))
%!    at = regexp (text, '^## ', 'lineanchors', 'once');
%!    writeAtomic (file, [text(1:at - 1), news, "\n\n* News.\n\n", text(at:end)]);
%!    commit (copy);
%!  end
%!endfunction

%!shared copy
%! copy = withNews (cloneOf ());

%!test
%! old = strtrim (fileread (fullfile (copy, 'VERSION')));
%! refused = @(words, said) in (copy, ['tools/release.sh ', words]) == 1 && ...
%!   ~isempty (strfind (nthargout (2, @in, copy, ['tools/release.sh ', words]), said));
%! assert (refused ('', 'three numbers'));
%! assert (refused ('1.0', 'three numbers'));
%! assert (refused (old, ['above ', old]));
%! assert (refused ('0.1.0', ['above ', old]));
%! file = fullfile (copy, 'new.txt');
%! writeAtomic (file, 'x');
%! assert (refused ('99.0.1', 'as it was committed'));
%! delete (file);
%! [status, out] = in (copy, 'tools/release.sh 99.0.1 without-site');
%! assert (status == 0, out);
%! assert (isfile (fullfile (copy, 'dist', 'decalioc-99.0.1.tar.gz')));
%! assert (strtrim (fileread (fullfile (copy, 'VERSION'))), '99.0.1');
%! assert (~isempty (regexp (fileread (fullfile (copy, 'CITATION.cff')), ...
%!                           '^version: 99\.0\.1$', 'lineanchors', 'once')));
%! assert (~isempty (regexp (fileread (fullfile (copy, 'CHANGELOG.md')), ...
%!                           '^## 99\.0\.1 \(\d{4}-\d\d-\d\d\)$', 'lineanchors', 'once')));
%! named = regexp (fileread (fullfile (copy, 'docs', 'install.md')), ...
%!                 'decalioc-([\d.]+)\.tar', 'tokens');
%! assert (unique ([named{:}]), {'99.0.1'});
%! assert (~isempty (strfind (out, 'git tag --annotate v99.0.1')), out);

%!test
%! % each file gets its line once, and keeps its help text and its tests
%! text = "% NEW  A function without the line.\n\nfunction new ()\nend\n\n%!assert (true)";
%! file = fullfile (copy, 'infrastructure', 'kit', 'files', 'new.m');
%! writeAtomic (file, text);
%! script = fullfile (copy, 'tools', 'new.sh');
%! writeAtomic (script, "#!/bin/bash\ntrue\n");
%! commit (copy);
%! copied = fullfile (copy, {'templates/case/loadInput.m', 'loadEffects.m', ...
%!                           'DEMmodels/Heap/meshes/makeHeap.m'});
%! asTheyWere = cellfun (@fileread, copied, 'UniformOutput', false);
%! [status, out] = in (copy, 'tools/spdx.sh');
%! assert (status, 1);
%! assert (~isempty (strfind (out, 'infrastructure/kit/files/new.m: the line')), out);
%! [status, out] = in (copy, 'tools/spdx.sh --add && tools/spdx.sh');
%! assert (status == 0, out);
%! assert (cellfun (@fileread, copied, 'UniformOutput', false), asTheyWere);
%! line = '% SPDX-License-Identifier: GPL-3.0-only';
%! assert (fileread (file), [text, "\n\n", line, "\n"]);
%! assert (fileread (script), ["#!/bin/bash\n#", line(2:end), "\ntrue\n"]);
%! before = fileread (file);
%! in (copy, 'tools/spdx.sh --add');
%! assert (fileread (file), before);
%! [passed, total] = test (file, 'quiet');
%! assert ([passed, total], [1, 1]);

% SPDX-License-Identifier: GPL-3.0-only
