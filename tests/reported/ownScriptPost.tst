% Issue 72, 3 and 4: results that another program makes of what a script writes; a
% script that writes no results, or moves nothing.

%!function [new, tried, place] = made (files, words)
%!  folder = fullfile (tempname (), 'rig');
%!  mkdir (folder);
%!  for file = files'
%!    [~, ~] = mkdir (fileparts (fullfile (folder, file{1})));
%!    writeAtomic (fullfile (folder, file{1}), file{2});
%!  end
%!  [status, new] = startCommand (folder, ['new --model H --script in.x --vary ', ...
%!    'mu=0.3:0.7 --seed toss --target angle=24:deg --output result.txt ', words, ...
%!    ' ../case']);
%!  assert (status == 0, new);
%!  place = fullfile (fileparts (folder), 'case');
%!  [~, tried] = startCommand (place, 'check --try');
%!endfunction
%!function yes = says (text, part)
%!  yes = ! isempty (strfind (text, part));
%!endfunction
%!shared script
%! script = ["variable mu index 0.5\nvariable toss index 10007\n", ...
%!           "print \"${mu} ${toss}\" file raw.txt\nif \"${mu} > 9\" then \"run 1\"\n", ...
%!           "print \"RUN COMPLETE\"\n"];
%!test
%! % as reported: said by new, by the trial, and not tried again
%! [new, tried, place] = made ({'in.x', script}, '');
%! assert (says (new, 'no line of the script writes result.txt'), new);
%! assert (says (tried, 'H: invalid'), tried);
%! assert (says (tried, 'the run has not written result.txt'), tried);
%! assert (numel (listRunFolders (place, 'H')), 1);
%!test
%! % a program of each kind, with what it names, beside the script or elsewhere
%! python = ["import own\nopen('result.txt', 'w').write('angle %g' % ", ...
%!           "(own.twice * float(open('raw.txt').read().split()[0])))\n"];
%! for row = {'post.py', python; 'post.sh', "echo angle 1 > result.txt\n"; ...
%!            'tools/post.sh', "echo angle 1 > result.txt\n"; ...
%!            'post.sh', "echo reading raw.txt\necho angle 1\n"; ...
%!            'post', "#!/usr/bin/awk -f\nBEGIN { print \"angle 1\" > \"result.txt\" }\n"}'
%!   [new, tried] = made ({'in.x', script; 'own.py', "twice = 2\n"; row{:}}, ...
%!                        ['--post ', row{1}]);
%!   assert (! says (new, 'NOTE'), new);
%!   assert (! isempty (regexp (tried, 'H: ok, .*\n +angle +(0\.\d+|1|1\.\d+), meas')), ...
%!           tried);
%! end
%! % one that fails is said as that
%! [~, tried] = made ({'in.x', script; 'post.sh', "echo no such dump >&2; exit 3\n"}, ...
%!                    '--post post.sh');
%! assert (says (tried, 'exit status 3') && says (tried, 'no such dump'), tried);
%!test
%! % the file is there, and holds something else; one that holds no number does
%! for line = {'${mu} ${toss}', 'slope ${mu}', '0,5', 'angle = ${mu} deg'}
%!   [~, tried] = made ({'in.x', strrep(script, '${mu} ${toss}" file raw.txt', ...
%!                                      [line{1}, '" file result.txt'])}, '');
%!   assert (says (tried, 'must hold 1 number(s) alone, lines NAME VALUE'), tried);
%!   assert (says (tried, 'begins with: '), tried);
%! end
%! [~, tried] = made ({'in.x', strrep(script, '${mu} ${toss}" file raw.txt', ...
%!                                    'angle nan" file result.txt')}, '');
%! assert (says (tried, 'Where nothing flows, return 0'), tried);
%!test
%! % nothing is run
%! new = made ({'in.x', strrep(script, 'run 1', 'clear')}, '');
%! assert (says (new, 'no command run'), new);
%!error <no such file> made ({'in.x', script}, '--post post.py')

% SPDX-License-Identifier: GPL-3.0-only
