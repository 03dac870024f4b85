% The examples of CONTRIBUTING.md, "Six tasks, and the files they touch": each patch
% of tests/patches/ applies to a copy of the toolbox as it is, touches as many files
% as patches.csv says, and the tests of the functions that it touches (and of those of
% the column also) pass there.

%!function folder = copyOf (root)
%!  folder = fullfile (emptyFolder (), 'toolbox');
%!  mkdir (folder);
%!  list = 'git ls-files -z --cached --others --exclude-standard';
%!  if system (sprintf ('git -C %s rev-parse > /dev/null 2>&1', shellQuote (root))) ~= 0
%!    list = ['find . \( -name optim -o -name .git \) -prune -o ', ...
%!            '\( -type f -o -type l \) -print0'];
%!  end
%!  status = system (sprintf (['cd %s && %s | tar --null --ignore-failed-read -T - ', ...
%!                             '-cf - 2> /dev/null | tar -xf - -C %s'], ...
%!                            shellQuote (root), list, shellQuote (folder)));
%!  assert (status, 0);
%!endfunction

%!function passed = testsOf (copy, files)
%!  % one Octave, which adds nothing of the toolbox that is tested here
%!  hasTests = @(f) ~isempty (regexp (fileread (fullfile (copy, f)), '^%!(test|assert)', ...
%!                                    'once', 'lineanchors'));
%!  files = unique (files);
%!  files = files(cellfun (hasTests, files));
%!  [queue, put] = emptyFolder ();
%!  put ('files', strjoin (fullfile (copy, files), "\t"));
%!  put ('deadline', 'Inf');
%!  program = shellQuote (fullfile (copy, 'tests', 'runTests.m'));
%!  [~, out] = system (sprintf ('octave-cli --no-gui --norc %s --queue %s 2>&1', program, ...
%!                              shellQuote (queue)));
%!  counts = fullfile (queue, '1', 'counts');
%!  assert (isfile (counts), out);
%!  counts = sscanf (fileread (counts), '%d')';
%!  assert (counts(2) == 0, out);
%!  passed = counts(1);
%!endfunction

%!test
%! root = fileparts (fileparts (which ('startProgram')));
%! place = fullfile (root, 'tests', 'patches');
%! [~, cells] = readCsvTable (fullfile (place, 'patches.csv'));
%! there = strrep (glob (fullfile (place, '*.patch')), [place, filesep()], '');
%! assert (sort (strcat (cells(:, 1), '.patch')), sort (there));
%! plain = copyOf (root);
%! program = 'git apply';
%! if isempty (file_in_path (getenv ('PATH'), 'git'))
%!   program = 'patch -p1 --fuzz=0 -i';
%! end
%! for row = cells'
%!   copy = fullfile (emptyFolder (), 'toolbox');
%!   system (sprintf ('cp -a %s %s', shellQuote (plain), shellQuote (copy)));
%!   patch = fullfile (place, [row{1}, '.patch']);
%!   [status, out] = system (sprintf ('cd %s && %s %s 2>&1', shellQuote (copy), program, ...
%!                                    shellQuote (patch)));
%!   assert (status == 0, [row{1}, ': ', out]);
%!   touched = regexp (fileread (patch), '^\+\+\+ b/(\S+)', 'tokens', 'lineanchors');
%!   touched = [touched{:}];
%!   assert (numel (touched) == str2double (row{2}), row{1});
%!   isOurs = ~cellfun (@isempty, regexp (touched, '^(infra|exam).*\.m$'));
%!   also = ostrsplit (row{3}, ' ', true);
%!   passed = testsOf (copy, [touched(isOurs), also]);
%!   assert (passed > 0, row{1});
%!   confirm_recursive_rmdir (false, 'local');
%!   rmdir (copy, 's');
%! end
%! rmdir (plain, 's');

% SPDX-License-Identifier: GPL-3.0-only
