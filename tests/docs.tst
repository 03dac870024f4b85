% Pages that tell a user what to type are followed literally: each block of
% commands is given to bash, in the order of the page, and a line to be changed is
% put into the file named before it. The blocks that calibrate or diagnose take
% minutes and are given only where DECALIOC_SOAK=1.

%!function blocks = commandsOf (page)
%!  % commands in the blocks of a page; those of a list are indented
%!  root = fileparts (fileparts (which ('startProgram')));
%!  text = fileread (fullfile (root, 'docs', page));
%!  found = regexp (text, '^ *```(\w*)\n(.*?)\n *```', 'tokens', 'lineanchors');
%!  found = vertcat (found{:});
%!  blocks = found(cellfun (@isempty, found(:, 1)), 2)';
%!endfunction

%!function [blocks, files] = stepsOf (page)
%!  % all blocks of a page; of a line to be changed the file that is named last
%!  root = fileparts (fileparts (which ('startProgram')));
%!  text = fileread (fullfile (root, 'docs', page));
%!  [found, at] = regexp (text, '^ *```(\w*)\n(.*?)\n *```', 'tokens', ...
%!                        'start', 'lineanchors');
%!  found = vertcat (found{:});
%!  blocks = found(:, 2)';
%!  files = repmat ({''}, size (blocks));
%!  for k = find (~cellfun (@isempty, found(:, 1)))'
%!    named = regexp (text(1:at(k)), '`(\w+/[\w./]+)`', 'tokens');
%!    files(k) = named{end};
%!  end
%!endfunction

%!function changeLine (file, line)
%!  % as in an editor: what stands left of the value finds the line
%!  left = regexp (line, '^\s*(variable \w+|\S+)', 'tokens', 'once'){1};
%!  lines = strsplit (fileread (file), "\n");
%!  isIt = strncmp (strtrim (lines), [left, ' '], numel (left) + 1);
%!  assert (sum (isIt) == 1, left);
%!  lines{isIt} = line;
%!  writeAtomic (file, strjoin (lines, "\n"));
%!endfunction

%!function [status, out] = follow (folder, block)
%!  root = fileparts (fileparts (which ('startProgram')));
%!  script = sprintf (['set -e; export DECALIOC=%s PATH=%s:$PATH; cd %s\n' ...
%!                     '%s\n'], shellQuote (root), ...
%!                    shellQuote (fullfile (root, 'bin')), ...
%!                    shellQuote (folder), block);
%!  [status, out] = system (['bash -c ', shellQuote(script), ...
%!                           ' 2>&1 < /dev/null']);
%!endfunction

%!function yes = takesLong (block)
%!  yes = any (regexp (block, '^decalioc (run|diagnose)', 'lineanchors')) && ...
%!        ~strcmp (getenv ('DECALIOC_SOAK'), '1');
%!endfunction

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! folder = fullfile (tempname (), 'a user''s');
%! mkdir (folder);
%! [blocks, files] = stepsOf ('quickstart.md');
%! assert (numel (blocks) >= 11 && sum (~cellfun (@isempty, files)) >= 2);
%! assert (strncmp (blocks{1}, 'make setup', 10));   % what tests stand on
%! for k = 2:numel (blocks)
%!   if ~isempty (files{k})
%!     changeLine (fullfile (folder, files{k}), blocks{k});
%!   elseif ~takesLong (blocks{k})
%!     [status, out] = follow (folder, blocks{k});
%!     assert (status == 0, [blocks{k}, "\n", out]);
%!   end
%! end
%! case_ = fullfile (folder, 'Repose');
%! head = headDefaults (fullfile (case_, 'DEMmodels', 'Repose', 'data.head'));
%! assert (head.plateRadius, 0.035);
%! text = fileread (fullfile (case_, 'loadInput.m'));
%! assert (~isempty (strfind (text, '[29.2, 0.0131, 0.0180]')));
%! % runs of the model as it was are left aside
%! [~, out] = follow (folder, 'decalioc status Repose');
%! assert (~isempty (strfind (out, 'left aside')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (folder), 's');

% --- extend.md: the model of four files, then its table of runs
%!function text = blockAfter (text, mark)
%!  from = strfind (text, mark);
%!  text = regexp (text(from(1):end), '```\w*\n(.*?)```', 'tokens', 'once'){1};
%!endfunction

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! root = fileparts (fileparts (which ('startProgram')));
%! text = fileread (fullfile (root, 'docs', 'extend.md'));
%! folder = tempname ();
%! copyfile (fullfile (root, 'examples', 'slump'), folder);
%! alone = [folder, '-alone'];
%! copyfile (fullfile (folder, 'DEMmodels', 'Slump'), alone);
%! [status, out] = follow (alone, 'bash runscript && cat output_centre');
%! assert (status == 0, out);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (alone, 's');
%! writeAtomic (fullfile (folder, 'loadEffects.m'), ...
%!              blockAfter (text, '**In four fields'));
%! [status, out] = follow (folder, 'decalioc check --try');
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, 'trial     Slump: ok')), out);
%! assert (~isempty (strfind (out, 'effects   bounce')), out);
%! writeAtomic (fullfile (folder, 'runs.csv'), ...
%!              blockAfter (text, '## Runs that exist already'));
%! [status, out] = follow (folder, 'decalioc check');
%! assert (~isempty (strfind (out, 'runs.csv  2 sets taken in')), out);
%! rmdir (folder, 's');

% --- the reading functions of extend.md are there and have the call shown
%!test
%! root = fileparts (fileparts (which ('startProgram')));
%! text = fileread (fullfile (root, 'docs', 'extend.md'));
%! from = strfind (text, '### Reading particle dumps');
%! part = text(from:from + strfind (text(from:end), "\n### Rules")(1));
%! names = regexp (part, '^\| `(?:[^=`]*= )?(\w+) \(', 'tokens', 'lineanchors');
%! names = unique ([names{:}]);
%! assert (numel (names) >= 10);
%! for name = names
%!   assert (exist (name{1}) == 2, name{1});
%! end
%! % the lines below the table run on the sample of a bench
%! code = blockAfter (part, '```octave');
%! folder = [tempname(), '/'];
%! mkdir (folder);
%! copyfile (fullfile (root, 'DEMmodels', 'Heap', 'sample', 'heap.dump'), ...
%!           folder);
%! eval (code);
%! assert (isfile ([folder, 'measured.svg']));
%! assert (inBox > 0 && angle > 20 && angle < 40);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% --- the example of gap.md on matrices names what it says
%!test
%! root = fileparts (fileparts (which ('startProgram')));
%! text = fileread (fullfile (root, 'docs', 'gap.md'));
%! code = strrep (blockAfter (text, '## On matrices'), 'pwd', 'root');
%! said = evalc (code);
%! assert (isequal (diagnosis.which.effects, {'cohesion'}), said);
%! assert (diagnosis.which.verdict, 'named');
%! assert (prod (diagnosis.which.strength.interval90 - 0.8) <= 0);

% --- worked-example.md: its one command, without LIGGGHTS, says what it quotes
%!function text = withoutNumbers (text)
%!  text = regexprep (text, '[-+]?\d[\d.]*(e[-+]?\d+)?', '#');
%!  text = regexprep (text, '[ \t]+', ' ');
%!endfunction

%!test
%! folder = tempname ();
%! mkdir (folder);
%! root = fileparts (fileparts (which ('startProgram')));
%! text = fileread (fullfile (root, 'docs', 'worked-example.md'));
%! command = commandsOf ('worked-example.md');
%! assert (numel (command), 1);
%! hidden = ['export XDG_CACHE_HOME=$PWD LIGGGHTS= PATH=$(IFS=:; ', ...
%!           'for d in $PATH; do [ -x "$d/liggghts" ] || ', ...
%!           'printf "%s:" "$d"; done)', "\n"];
%! [status, out] = follow (folder, [hidden, command{1}]);
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, 'LIGGGHTS: none found')), out);
%! assert (isfile (fullfile (folder, 'sticky', 'results', 'report.html')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! quoted = regexp (text, '```text\n(.*?)```', 'tokens');
%! lines = strsplit (strtrim ([[quoted{:}]{:}]), "\n");
%! assert (numel (lines) > 30);
%! said = cellfun (@strtrim, strsplit (withoutNumbers (out), "\n"), ...
%!                 'UniformOutput', false);
%! shown = cellfun (@(line) strtrim (withoutNumbers (line)), lines, ...
%!                  'UniformOutput', false);
%! missing = lines(~ismember (shown, said));
%! assert (isempty (missing), strjoin ([missing, {''}], "\n"));

% --- tutorial.md: its commands as they stand; no word that the glossary has to explain
%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'liggghts'))
%! folder = fullfile (tempname (), 'a student');
%! mkdir (folder);
%! blocks = commandsOf ('tutorial.md');
%! assert (numel (blocks) >= 7);
%! for block = blocks
%!   if ~takesLong (block{1})
%!     [status, out] = follow (folder, block{1});
%!     % 2: not all that was measured is met, as the page says of the damp grains
%!     isRun = ~isempty (regexp (block{1}, '^decalioc run', 'lineanchors'));
%!     assert (status == 0 || (status == 2 && isRun), [block{1}, "\n", out]);
%!   end
%! end
%! assert (isfile (fullfile (folder, 'Mine', 'measured.csv')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (fileparts (folder), 's');

%!test
%! docs = fullfile (fileparts (fileparts (which ('startProgram'))), 'docs');
%! terms = regexp (fileread (fullfile (docs, 'glossary.md')), '^\* \*\*(.*?)\*\*', ...
%!                 'tokens', 'lineanchors');
%! terms = strtrim (strsplit (strjoin ([terms{:}], ','), ','));
%! text = regexprep (fileread (fullfile (docs, 'tutorial.md')), ...
%!                   {'```.*?```', '`[^`]*`', '\]\([^)]*\)'}, ' ');
%! isThere = @(term) ~isempty (regexpi (text, ['\<', regexptranslate('escape', term), ...
%!                                            's?\>'], 'once'));
%! found = terms(cellfun (isThere, terms));
%! assert (numel (terms) > 30 && isempty (found), strjoin ([found, {''}], ', '));

% --- functions.md is what its tool makes of the functions as they are
%!test
%! root = fileparts (fileparts (which ('startProgram')));
%! [status, out] = system ([shellQuote(fullfile (root, 'tools', ...
%!                          'functionIndex.sh')), ' --check 2>&1']);
%! assert (status == 0, out);

% --- troubleshooting.md knows every error, and no error that is not there
%!function names = inCode (root)
%!  [~, list] = system (['find ', shellQuote(fullfile (root, 'infrastructure')), ' ', ...
%!                       shellQuote(fullfile (root, 'templates')), ' -name "*.m"']);
%!  names = {};
%!  for file = [strsplit(strtrim (list), "\n"), ...
%!              {which('DEcalioc'), which('diagnoseGap')}]
%!    lines = regexp (fileread (file{1}), '^(?!\s*%).*$', 'match', ...
%!                    'lineanchors', 'dotexceptnewline');
%!    found = regexp (lines, '''(DEcalioc:\w+:\w+)''', 'tokens');
%!    found = [found{:}];
%!    names = [names, found{:}];
%!  end
%!  names = unique (names);
%!endfunction

%!test
%! root = fileparts (fileparts (which ('startProgram')));
%! text = [fileread(fullfile (root, 'docs', 'troubleshooting.md')), ...
%!         fileread(fullfile (root, 'docs', 'identifiers.md'))];
%! onPage = unique (regexp (text, '(?<=`)DEcalioc:\w+:\w+(?=`)', 'match'));
%! raised = inCode (root);
%! raised(strncmp (raised, 'DEcalioc:checkCase:', 19)) = [];  % inputsDoc.tst
%! assert (numel (raised) > 60);
%! missing = setdiff (raised, onPage);
%! assert (isempty (missing), strjoin ([missing, {''}], ' '));
%! dead = setdiff (onPage, raised);
%! assert (isempty (dead), strjoin ([dead, {''}], ' '));

% --- links of all pages lead to files and headings that are there
%!function name = anchorOf (heading)
%!  name = lower (regexprep (heading, '[^\w\s-]', ''));
%!  name = strrep (strtrim (name), ' ', '-');
%!endfunction

%!function bad = badLinks (page)
%!  bad = {};
%!  text = regexprep (fileread (page), '```.*?```', '');
%!  for link = regexp (text, '\]\(([^)\s]+)\)', 'tokens')
%!    parts = strsplit ([link{1}{1}, '#'], '#');
%!    if any (strncmp (parts{1}, {'http:', 'https:', 'mailto'}, 5))
%!      continue
%!    end
%!    file = page;
%!    if ~isempty (parts{1})
%!      file = fullfile (fileparts (page), parts{1});
%!    end
%!    isGood = isfile (file) || isfolder (file);
%!    if isGood && ~isempty (parts{2})
%!      heads = regexp (fileread (file), '^#+ (.*)$', 'tokens', ...
%!                      'lineanchors', 'dotexceptnewline');
%!      heads = cellfun (@(t) anchorOf (t{1}), heads, 'UniformOutput', false);
%!      isGood = any (strcmp (parts{2}, heads));
%!    end
%!    if ~isGood
%!      bad{end + 1} = [page, ': ', link{1}{1}];
%!    end
%!  end
%!endfunction

%!test
%! root = fileparts (fileparts (which ('startProgram')));
%! pages = [glob(fullfile (root, '*.md')); glob(fullfile (root, 'docs', ...
%!          '*.md')); glob(fullfile (root, {'*', '*/*'}, 'README.md'))];
%! assert (numel (pages) > 20);
%! bad = cellfun (@badLinks, pages', 'UniformOutput', false);
%! bad = [bad{:}];
%! assert (isempty (bad), strjoin ([bad, {''}], "\n"));

%!test
%! % the files that CONTRIBUTING.md sends a newcomer to are there
%! root = fileparts (fileparts (which ('startProgram')));
%! text = fileread (fullfile (root, 'CONTRIBUTING.md'));
%! files = regexp (text, '`((infrastructure|tests)/[\w/]*\.?\w*)`', 'tokens');
%! files = cellfun (@(f) f{1}, files, 'UniformOutput', false);
%! files(~cellfun (@isempty, strfind (files, 'NAME'))) = [];
%! assert (numel (files) >= 8);
%! there = cellfun (@(f) exist (fullfile (root, f)) > 0, files);
%! assert (all (there), strjoin ([files(~there), {''}], ' '));

%!test
%! % a link to nowhere is found
%! page = [tempname(), '.md'];
%! writeAtomic (page, "# A b\n[x](#a-b) [y](#c) [z](no.md) [w](http://a)\n");
%! bad = badLinks (page);
%! unlink (page);
%! assert (bad, {[page, ': #c'], [page, ': no.md']});

%!test
%! % every page of docs/ is in the list of pages; lines are short but for tables
%! root = fileparts (fileparts (which ('startProgram')));
%! list = fileread (fullfile (root, 'docs', 'README.md'));
%! for page = glob (fullfile (root, 'docs', '*.md'))'
%!   [~, name] = fileparts (page{1});
%!   assert (strcmp (name, 'README') || ...
%!           ~isempty (strfind (list, ['(', name, '.md)'])), name);
%! end
%! assert (numel (strsplit (fileread (fullfile (root, 'README.md')))) < 950);

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'python3'))
%! % phrases that the manual does without are found across lines, not in code
%! root = fileparts (fileparts (which ('startProgram')));
%! page = [tempname(), '.md'];
%! writeAtomic (page, ["Noise makes as\nmuch. `a box` [x](a-set.md)\n\n", ...
%!                     "```\nthe sets\n```\n\n* There\n  are misses.\n"]);
%! [status, out] = system (sprintf ('python3 %s %s 2>&1', ...
%!   shellQuote (fullfile (root, 'tools', 'phrases.py')), shellQuote (page)));
%! unlink (page);
%! assert (status == 1, out);
%! found = regexp (out, ':(\d+): "([^"]*)"', 'tokens');
%! assert (vertcat (found{:}), {'1', 'as much'; '8', 'There are'});

% SPDX-License-Identifier: GPL-3.0-only
