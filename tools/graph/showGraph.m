% SHOWGRAPH  Prints the calls between the folders, and what is wrong with them.
%
% CALL: failed = showGraph (root)
%
% root    folder of the toolbox (text)
% failed  1 where a call goes up or into the private folder of another (out of
%         benchmarks, tests, tools and models, too), two folders call each other,
%         a function has no caller, or a declared exception is none; else 0 (exit
%         status of make graph)
%
% The table of mayCall is the rule: whom each folder may call besides itself.
% The subfolders of a folder call each other one way only. What is different on
% purpose stands in the table of declared, and is printed. A function without a
% caller is one that no other calls, and that no page of docs/, no model and no
% program in bin/ names: those are for the user. The helpers of tests/ are
% looked at too.
%
% See also: folderCalls

function failed = showGraph (root)
  [names, places, calls, inside] = folderCalls (root);
  tops = roomsOf (places);
  rule = mayCall ();
  unknown = setdiff (tops, rule(:, 1));
  if ~isempty (unknown)
    error ('DEcalioc:showGraph:unknownName', ...
           'showGraph: the table of mayCall must have the folder %s.', ...
           unknown{1});
  end
  printMatrix (rule(:, 1), tops, calls);
  for folder = unique (tops(~strcmp (tops, places)))'
    printMatrix (unique (places(strcmp (tops, folder{1}))), places, calls);
  end
  [calls, excused, stale] = excuse (names, calls);
  faults = [upward(rule, names, places, calls), ...
            intoPrivate(names, places, calls, inside), ...
            testsIntoPrivate(root), ...
            mutual(names, places, calls), stale, ...
            withoutCaller(root, names, calls | excused), ...
            withoutTest(root)];
  printf ('%s\n', faults{:});
  failed = double (~isempty (faults));
end

% The order of the layers, from the top.
function rule = mayCall ()
  low = {'effects', 'case', 'measure', 'kit'};
  mid = [{'problem', 'published', 'surrogates', 'runs'}, low];
  core = [{'diagnosis', 'calibration', 'report'}, mid];
  rule = {'main', core; ...
          'wings/command', [{'wings/script'}, core]; ...
          'wings/script', {'case', 'measure', 'kit'}; ...
          'diagnosis', [{'calibration', 'report'}, mid]; ...
          'calibration', [{'report'}, mid]; ...
          'report', mid; ...
          'published', [{'surrogates', 'runs'}, low]; ...
          'problem', [{'surrogates'}, low]; ...
          'surrogates', low; ...
          'runs', low; ...
          'effects', {'case', 'kit'}; ...
          'case', {'kit'}; ...
          'measure', {'kit'}; ...
          'kit', {}};
end

% Calls that are as they should be: caller, called (a pattern), why.
function list = declared ()
  list = {'ownCost', 'costFunction', 'form of the user'; ...
          'readInput', 'loadInput', 'form of the user'; ...
          'withEffects', 'loadEffects', 'form of the user'; ...
          'getEffect', 'effect[A-Z]\w*', 'found by its file'; ...
          'describeExecutor', '\w+Executor', 'found by its file'; ...
          'describeExecutor', 'execute[A-Z]\w*', 'found by its file'; ...
          'improveByInfill', 'infill[A-Z]\w*', 'found by its file'; ...
          'withoutUnvaried', 'importRuns', 'a table alone says what it varies'; ...
          'checkFindModels', 'checkDryRunWorker', 'in an Octave of its own'};
end

% Takes the declared calls out. Those that the code does not show count as calls
% all the same; one whose functions are not there is an exception of nothing.
function [calls, excused, stale] = excuse (names, calls)
  excused = false (size (calls));
  stale = {};
  for row = declared ()'
    from = strcmp (names, row{1});
    to = ~cellfun (@isempty, regexp (names, ['^', row{2}, '$'], 'once'));
    printf ('Declared: %s calls %s (%s)\n', row{:});
    if ~any (from) || ~any (to)
      stale{end + 1} = ['Declared, but not there: ', row{1}, ' ', row{2}];
    end
    calls(from, to) = false;
    excused(from, to) = true;
  end
end

function printMatrix (folders, places, calls)
  short = regexprep (folders, '^.*/', '');
  printf ('%-12s%s  files\n', 'calls', sprintf (' %5.5s', short{:}));
  for k = 1:numel (folders)
    mine = strcmp (places, folders{k});
    counts = cellfun (@(f) nnz (calls(mine, strcmp (places, f))), folders);
    cells = strrep (sprintf (' %5d', counts), '     0', '     .');
    printf ('%-12s%s %6d\n', short{k}, cells, sum (mine));
  end
end

function faults = upward (rule, names, places, calls)
  tops = roomsOf (places);
  for k = 1:rows (rule)
    mine = strcmp (tops, rule{k, 1});
    allowed = ismember (tops, [rule(k, 1), rule{k, 2}]);
    calls(mine, allowed) = false;
  end
  faults = faultLines ('Upward', names, places, calls);
end

% Between two subfolders of one folder. The folder itself holds their way in and
% what they share, and so both calls them and is called.
function faults = mutual (names, places, calls)
  [folders, ~, folderOf] = unique (places);
  count = zeros (numel (folders));
  [from, to] = find (calls);
  count(sub2ind (size (count), folderOf(from), folderOf(to))) = 1;
  both = count & count' & ~eye (numel (folders));
  isSub = ~cellfun (@isempty, strfind (folders, '/'));
  both = both & isSub & isSub';
  calls = calls & both(folderOf, folderOf);
  faults = faultLines ('Both ways', names, places, calls);
end

% A private function is found from its folder, and by its neighbours there.
function faults = intoPrivate (names, places, calls, inside)
  [~, ~, folderOf] = unique (places);
  calls = calls & folderOf ~= folderOf' & inside';
  faults = faultLines ('Private', names, places, calls);
end

% Programs that measure, models and tests call what is public, too: they end with
% an error where it is not, and nobody sees that before they are run.
function faults = testsIntoPrivate (root)
  [names, places, calls, inside] = ...
    folderCalls (root, {'benchmarks', 'tests', 'tools', 'DEMmodels', ...
                        'examples', 'templates'});
  calls(~strcmp (places, 'main'), :) = false;
  faults = intoPrivate (names, places, calls, inside);
end

function faults = faultLines (what, names, places, calls)
  [from, to] = find (calls);
  faults = arrayfun (@(a, b) sprintf ('%s: %s/%s calls %s/%s', what, ...
                                      places{a}, names{a}, places{b}, ...
                                      names{b}), ...
                     from(:)', to(:)', 'UniformOutput', false);
end

function faults = withoutCaller (root, names, calls)
  pages = [glob(fullfile (root, 'docs', '*.md')); ...
           glob(fullfile (root, 'README.md'))];
  spans = regexp (cellfun (@fileread, pages, 'UniformOutput', false), ...
                  '```.*?```|`[^`]+`', 'match');
  models = [glob(fullfile (root, 'DEMmodels', '*', '*', '*.m')); ...
            glob(fullfile (root, 'templates', '*', '*', '*', '*', '*.m'))];
  programs = [models; glob(fullfile (root, 'bin', '*'))];
  texts = [{''}, spans{:}, cellfun(@fileread, programs, ...
                                   'UniformOutput', false)'];
  % an identifier of an error names its function without a call
  texts = regexprep (strjoin (texts, "\n"), 'DEcalioc:\w+', '');
  alone = names(~any (calls, 1));
  isSaid = cellfun (@(n) isWordOf (n, texts), alone);
  faults = strcat ({'Without a caller: '}, alone(~isSaid))';
end

% Functions of tests/ that neither a test nor another helper names.
function faults = withoutTest (root)
  faults = {};
  helpers = glob (fullfile (root, 'tests', '*.m'));
  files = {fullfile(root, 'Makefile')};
  for part = {'infrastructure', 'tests', 'benchmarks', 'tools'}
    for folder = strsplit (genpath (fullfile (root, part{1})), pathsep ())
      files = [files; glob(fullfile (folder{1}, ...
                                     {'*.m', '*.tst', '*.sh', 'private/*.m'}))];
    end
  end
  files = files(cellfun (@(f) exist (f, 'file') == 2, files));
  texts = cellfun (@fileread, files, 'UniformOutput', false);
  texts = regexprep (texts, '^% .*$', '', 'lineanchors', 'dotexceptnewline');
  for k = 1:numel (helpers)
    [~, name] = fileparts (helpers{k});
    others = ~strcmp (files, helpers{k});
    if ~any (cellfun (@(t) isWordOf (name, t), texts(others)))
      faults{end + 1} = ['Without a test: ', name];
    end
  end
end

function yes = isWordOf (name, text)
  yes = ~isempty (strfind (text, name)) && ...
        ~isempty (regexp (text, ['\<', name, '\>'], 'once'));
end

%!function [failed, said] = graphOf (root)
%!  said = evalc ('failed = showGraph (root);');
%!  said = strsplit (said, "\n");
%!endfunction

%!test
%! % the toolbox itself, in a copy into which faults are planted: functions of
%! % names that stand nowhere, not even here
%! scratch = tempname ();
%! mkdir (scratch);
%! root = fileparts (fileparts (fileparts (which ('showGraph'))));
%! for part = {'infrastructure', 'tests', 'docs', 'templates', 'tools', ...
%!             'DEMmodels', 'benchmarks', 'bin', 'Makefile', 'README.md', '*.m'}
%!   copyfile (fullfile (root, part{1}), scratch);
%! end
%! [failed, said] = graphOf (scratch);
%! assert (failed == 0, strjoin (said, "\n"));
%! assert (any (strncmp (said, 'Declared: readInput calls loadInput', 30)));
%!
%! folders = strsplit (genpath (fullfile (scratch, 'infrastructure')), ...
%!                     pathsep ());
%! folders = folders(cellfun (@(f) numel (glob (fullfile (f, '*.m'))) > 0, ...
%!                             folders));
%! assert (numel (folders) > 15);
%! inside = @(place) fullfile (scratch, 'infrastructure', place);
%! nobody = ['nobody', 'CallsMe'];
%! wanted = {};
%! % without a caller: in whatever folder
%! for k = 1:numel (folders)
%!   plant = {folders{k}, sprintf('%s%d', nobody, k), 'x = 1'};
%!   writeAtomic (fullfile (plant{1}, [plant{2}, '.m']), ...
%!                sprintf ("function %s ()\n  %s;\nend\n", plant{2:3}));
%!   wanted{end + 1} = ['Without a caller: ', plant{2}];
%! end
%! % upward by name, in four ways; a subfolder calls back into its neighbour,
%! % by a handle; a helper of the tests without a test
%! up = {'feval (''runJobs'')', 'f = str2func ([''runJ'', name])', ...
%!       'parcellfun (2, ''runJobs'', {})', 'evalc (''runJobs (1)'')'};
%! wanted = [wanted, {['Both ways: diagnosis/hypotheses/', nobody, 'E calls ', ...
%!                     'diagnosis/where/locateGap'], ['Without a test: ', nobody]}];
%! wanted{end + 1} = ['Private: diagnosis/hypotheses/', nobody, 'F calls ', ...
%!                   'calibration/budgetLeft'];
%! wanted{end + 1} = ['Private: main/', nobody, 'G calls calibration/budgetLeft'];
%! plants = {inside('diagnosis/hypotheses'), 'E', 'f = @locateGap'; ...
%!           inside('diagnosis/hypotheses'), 'F', 'budgetLeft (1)'; ...
%!           fullfile(scratch, 'benchmarks'), 'G', 'budgetLeft (1)'; ...
%!           fullfile(scratch, 'tests'), '', 'x = 1'};
%! for k = 1:4
%!   plants(end + 1, :) = {inside('kit'), char('A' + k - 1), up{k}};
%!   wanted{end + 1} = ['Upward: kit/', nobody, plants{end, 2}, ...
%!                      ' calls runs/runJobs'];
%! end
%! for plant = plants'
%!   name = [nobody, plant{2}];
%!   writeAtomic (fullfile (plant{1}, [name, '.m']), ...
%!                sprintf ("function %s ()\n  %s;\nend\n", name, plant{3}));
%! end
%! % an exception of nothing
%! unlink (fullfile (inside ('case/check'), 'checkDryRunWorker.m'));
%! wanted{end + 1} = ['Declared, but not there: checkFindModels ', ...
%!                    'checkDryRunWorker'];
%! [failed, said] = graphOf (scratch);
%! assert (failed, 1);
%! assert (cell (1, 0), setdiff (wanted, said));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (scratch, 's');
%!test
%! % a folder that is in no layer
%! scratch = tempname ();
%! mkdir (fullfile (scratch, 'infrastructure', 'new'));
%! writeAtomic (fullfile (scratch, 'infrastructure', 'new', 'x.m'), ...
%!              "function x ()\nend\n");
%! caught = '';
%! try
%!   graphOf (scratch);
%! catch err
%!   caught = err.identifier;
%! end
%! assert (caught, 'DEcalioc:showGraph:unknownName');

% SPDX-License-Identifier: GPL-3.0-only
