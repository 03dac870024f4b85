% Tables of the manual are those of benchmarks/results: a value that was changed, a
% table that is older than the code, a mark or results without each other are said.

%!function copy = smallManual ()
%!  % one page with one table, and a room of code, as a clone
%!  root = fileparts (fileparts (which ('startProgram')));
%!  copy = emptyFolder ();
%!  for part = {'benchmarks', 'infrastructure'}
%!    copyfile (fullfile (root, part{1}), fullfile (copy, part{1}));
%!  end
%!  results = fullfile (copy, 'benchmarks', 'results');
%!  kept = fullfile (results, 'demStage.csv');
%!  text = fileread (kept);
%!  delete (fullfile (results, '*.csv'));
%!  writeAtomic (fullfile (copy, 'README.md'), ...
%!               "# A\n\n<!-- figures: demStage -->\n<!-- end of figures -->\n");
%!  delete (fullfile (copy, 'benchmarks', 'README.md'));
%!  commit (copy, 'the code');
%!  [~, code] = system (sprintf ('git -C %s rev-parse --short=8 HEAD', shellQuote (copy)));
%!  writeAtomic (kept, regexprep (text, 'commit: \w+', ['commit: ', strtrim(code)], ...
%!                                'once'));
%!endfunction

%!function commit (folder, message)
%!  git = sprintf (['git -C %s -c init.defaultBranch=main -c user.name=a ', ...
%!                  '-c user.email=a@b '], shellQuote (folder));
%!  [status, out] = system ([git, 'init -q && ', git, 'add -A && ', git, ...
%!                           'commit -q -m ''', message, ''' 2>&1']);
%!  assert (status == 0, out);
%!endfunction

%!function [status, out] = figures (folder, word)
%!  program = fullfile (folder, 'benchmarks', 'figures.m');
%!  [status, out] = system (sprintf ('octave-cli --norc --no-gui %s %s 2>&1', ...
%!                                   shellQuote (program), word));
%!endfunction

%!function change (file, old, new)
%!  text = fileread (file);
%!  assert (~isempty (strfind (text, old)), old);
%!  writeAtomic (file, strrep (text, old, new));
%!endfunction

%!test
%! copy = smallManual ();
%! page = fullfile (copy, 'README.md');
%! csv = fullfile (copy, 'benchmarks', 'results', 'demStage.csv');
%! [status, out] = figures (copy, 'check');
%! assert (status, 1);
%! assert (~isempty (strfind (out, 'README.md: a table is not that of its results')), out);
%! [status, out] = figures (copy, '');
%! assert (status == 0 && isempty (strfind (out, 'WARNING')), out);
%! assert (~isempty (strfind (fileread (page), '| plain | published | 20 |')));
%! [status, out] = figures (copy, 'check');
%! assert (status == 0, out);
%! % a value is changed
%! whole = fileread (csv);
%! change (csv, "plain,robust,1,1,1,", "plain,robust,1,1,0,");
%! [status, out] = figures (copy, 'check');
%! assert (status, 1);
%! assert (~isempty (strfind (out, 'README.md: a table is not that of its results')), out);
%! writeAtomic (csv, whole);
%! % the code goes on: said, and no fault
%! commit (copy, 'the table');
%! code = fullfile (copy, 'infrastructure', 'calibration', 'confirmSet.m');
%! writeAtomic (code, [fileread(code), "\n% a remark\n%!test\n%! assert (true);\n"]);
%! commit (copy, 'a remark and a test');
%! [~, out] = figures (copy, 'check');
%! assert (isempty (strfind (out, 'has changed')), out);
%! writeAtomic (code, [fileread(code), "\n1;\n"]);
%! commit (copy, 'later code');
%! [status, out] = figures (copy, 'check');
%! assert (status == 0, out);
%! assert (~isempty (regexp (out, 'calibration has changed \(\w+ of \S+\) after: demStage')), ...
%!         out);
%! assert (isempty (strfind (out, 'surrogates has changed')), out);
%! assert (isempty (strfind (out, 'no commit of this clone')), out);
%! writeAtomic (csv, regexprep (whole, 'commit: \w+', 'commit: 0123456789', 'once'));
%! [~, out] = figures (copy, 'check');
%! assert (~isempty (strfind (out, 'in no commit of this clone: demStage')), out);

%!test
%! % what does not belong together
%! copy = smallManual ();
%! figures (copy, '');
%! results = fullfile (copy, 'benchmarks', 'results');
%! page = fullfile (copy, 'README.md');
%! writeAtomic (fullfile (results, 'mine.csv'), "a,b\n1,2\n");
%! change (page, 'figures: demStage', 'figures: noSuch');
%! [status, out] = figures (copy, 'check');
%! assert (status, 1);
%! for said = {'the mark noSuch has no table or no results', ...
%!             'demStage.csv: no table of a page and no program uses it', ...
%!             'mine.csv: no table of a page and no program uses it', ...
%!             'mine.csv: the first lines must say what made it'}
%!   assert (~isempty (strfind (out, said{1})), out);
%! end
%! change (page, '<!-- end of figures -->', '');
%! [status, out] = figures (copy, 'check');
%! assert (status == 1 && ~isempty (strfind (out, 'a mark of a table has no end')), out);

% SPDX-License-Identifier: GPL-3.0-only
