% SHOWGRAPH  Prints the calls between the folders, and what is wrong with them.
%
% CALL: failed = showGraph (root)
%
% root    folder of the toolbox (text)
% failed  1 where a call goes up, or a function has no caller and is neither
%         published nor documented; else 0 (exit status of make graph)
%
% The table of mayCall is the rule: whom each folder may call besides itself.
% Executors, effects and sections of the page are called by names put together
% from texts, which is how runs reach executors; such calls are not seen here.
%
% See also: folderCalls

function failed = showGraph (root)
  [names, places, calls] = folderCalls (root);
  rule = mayCall ();
  unknown = setdiff (places, rule(:, 1));
  if ~isempty (unknown)
    error ('DEcalioc:showGraph:unknownName', ...
           'showGraph: the table of mayCall must have the folder %s.', ...
           unknown{1});
  end
  printMatrix (rule(:, 1), places, calls);
  up = upward (rule, places, calls);
  [from, to] = find (up);
  for k = 1:numel (from)
    printf ('Upward: %s/%s calls %s/%s\n', places{from(k)}, names{from(k)}, ...
            places{to(k)}, names{to(k)});
  end
  alone = withoutCaller (root, names, places, calls);
  printf ('Without a caller: %s\n', alone{:});
  failed = double (~isempty (from) || ~isempty (alone));
end

% The order of the layers, from the top.
function rule = mayCall ()
  low = {'effects', 'case', 'files', 'statistics'};
  mid = [{'published', 'surrogates', 'runs'}, low];
  rule = {'main', [{'gap', 'calibration', 'report', 'executors'}, mid]; ...
          'gap', [{'calibration', 'report'}, mid]; ...
          'calibration', [{'report'}, mid]; ...
          'report', mid; ...
          'executors', {'published', 'runs', 'case', 'files'}; ...
          'published', [{'surrogates', 'runs'}, low]; ...
          'surrogates', low; ...
          'runs', low; ...
          'effects', {'case', 'files'}; ...
          'case', {'files'}; ...
          'files', {}; ...
          'statistics', {}};
end

function up = upward (rule, places, calls)
  up = calls;
  for k = 1:rows (rule)
    mine = strcmp (places, rule{k, 1});
    allowed = ismember (places, [rule(k, 1), rule{k, 2}]);
    up(mine, allowed) = false;
  end
end

function printMatrix (folders, places, calls)
  printf ('%-12s%s  files\n', 'calls', sprintf (' %5.5s', folders{:}));
  for k = 1:numel (folders)
    mine = strcmp (places, folders{k});
    counts = cellfun (@(f) nnz (calls(mine, strcmp (places, f))), folders);
    cells = strrep (sprintf (' %5d', counts), '     0', '     .');
    printf ('%-12s%s %6d\n', folders{k}, cells, sum (mine));
  end
end

% Published functions are ways in. Those for users are documented, or called by
% the models.
function list = withoutCaller (root, names, places, calls)
  files = [glob(fullfile (root, 'docs', '*.md')); ...
           glob(fullfile (root, 'DEMmodels', '*', '*', '*.m'))];
  texts = cellfun (@fileread, files, 'UniformOutput', false);
  texts = strjoin (texts, "\n");
  byName = ['^(execute|effect|section)[A-Z]|[a-z]Executor$|', ...
            '^(commandMain|checkDryRunWorker)$'];
  isAlone = ~any (calls, 1)' & ...
            ~ismember (places, {'published'}) & ...
            cellfun (@isempty, regexp (names, byName, 'once'));
  list = names(isAlone);
  isSaid = cellfun (@(n) ~isempty (regexp (texts, ['\<', n, '\>'], ...
                                           'once')), list);
  list = list(~isSaid)';
end

%!function failed = graphOf (caller, callee)
%!  % of a toolbox of two functions, the first of which calls the second
%!  root = tempname ();
%!  for folder = {'docs', fileparts(caller), fileparts(callee)}
%!    [~, ~] = mkdir (fullfile (root, folder{1}));
%!  end
%!  [~, called] = fileparts (callee);
%!  [~, calling] = fileparts (caller);
%!  writeAtomic (fullfile (root, 'docs', 'a.md'), ['See ', calling]);
%!  writeAtomic (fullfile (root, [caller, '.m']), ...
%!               ["function ", calling, "\n", called, " ();\nend\n"]);
%!  writeAtomic (fullfile (root, [callee, '.m']), ...
%!               ["function ", called, "\nend\n"]);
%!  evalc ('failed = showGraph (root);');
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (root, 's');
%!endfunction

%!assert (graphOf ('infrastructure/runs/a', 'infrastructure/files/b'), 0)
%!assert (graphOf ('infrastructure/files/a', 'infrastructure/runs/b'), 1)
%!assert (graphOf ('infrastructure/case/a', 'infrastructure/startRun'), 1)
%!assert (graphOf ('infrastructure/case/a', 'infrastructure/case/see'), 0)
%!error id=DEcalioc:showGraph:unknownName
%! graphOf ('infrastructure/new/a', 'infrastructure/files/b');
