% RUNTESTS  Runs the tests of the functions and the flows.
%
% CALL: octave-cli tests/runTests.m [PATTERN]
%       octave-cli tests/runTests.m --queue FOLDER
%
%   PATTERN  run all files whose path holds this text
%   --queue  one of the Octaves that the first call starts: takes the files of
%            the list in FOLDER one by one, until none is left
%
% Without a pattern these are the tests of the toolbox and the flows (*.tst)
% that flowsOf says: of the environment, DECALIOC_TEST_LIMIT is the seconds of
% processor after which a file is ended, DECALIOC_SOAK=1 asks for all flows, in
% their long form, and for the tests of benchmarks/; CHANGED is a list of files
% that have changed.
%
% Some Octaves share the files, the slowest flows first. The last line reads: N
% passed, N failed. The exit status is 1 if any failed.

1;

% IFTIME: 1 x n logical, files that are there only for what has changed.
function [files, ifTime] = testFiles (root, pattern)
  [~, list] = system (['cd ', shellQuote(root), ' && find "$PWD" ', ...
                       '\( -name optim -o -name .git \) -prune -o ', ...
                       '\( -name "*.m" -o -name "*.tst" \) -print | sort']);
  files = strsplit (strtrim (list), "\n");
  hasTests = @(f) ~isempty (regexp (fileread (f), '^%!', 'once', ...
                                    'lineanchors'));
  files = files(cellfun (hasTests, files));
  if ~isempty (pattern)
    files = files(~cellfun (@isempty, strfind (files, pattern)));
    ifTime = false (size (files));
    if isempty (files)
      error ('runTests: no file with tests has ''%s'' in its path.', pattern);
    end
    return
  end
  changed = strsplit (getenv ('CHANGED'), "\n");
  if strcmp (getenv ('DECALIOC_SOAK'), '1')
    changed = {'.'};
  end
  isFlow = ~cellfun (@isempty, regexp (files, '\.tst$'));
  isStudy = strncmp (files, [root, '/benchmarks/'], numel (root) + 12);
  [flows, always] = flowsOf (root, changed);
  studies = files(isStudy & any (strcmp (changed, '.') | ...
                                 strncmp (changed, 'benchmarks/', 11)));
  needed = [flows(always), files(~isFlow & ~isStudy)];
  files = [needed, flows(~always), studies];
  ifTime = 1:numel (files) > numel (needed);
end

% Claims a line of the list by making a folder, which only one process can. A
% file behind a question mark is not begun after the deadline.
function runQueue (root, queue)
  lines = strsplit (fileread (fullfile (queue, 'files')), "\n");
  deadline = str2double (fileread (fullfile (queue, 'deadline')));
  for k = 1:numel (lines)
    claim = fullfile (queue, sprintf ('%d', k));
    if isfolder (claim) || system (['mkdir ', claim, ' 2> /dev/null']) ~= 0
      continue
    end
    files = strsplit (lines{k}, "\t");
    counts = zeros (numel (files), 3);
    [said, late] = deal ('');
    for i = 1:numel (files)
      if files{i}(1) == '?' && time () > deadline
        late = [late, sprintf(' %s', files{i}(numel (root) + 3:end))];
        continue
      end
      [counts(i, :), text] = runFile (strrep (files{i}, '?', ''), root, ...
                                      fullfile (claim, 'limit'));
      said = [said, repmat(text, 1, counts(i, 2) > 0)];
    end
    saveText (fullfile (claim, 'failed'), said);
    saveText (fullfile (claim, 'late'), late);
    saveText (fullfile (claim, 'counts'), sprintf ('%d ', sum (counts, 1)));
  end
end

function saveText (file, text)
  fid = fopen (file, 'w');
  fputs (fid, text);
  fclose (fid);
end

% A file that never ends would keep all others from being told: its Octave is
% killed with all that it started when these have used 15 minutes of processor (two
% hours in the long form), or four times that by the clock; NOTE then says so.
function [counts, text] = runFile (file, root, note)
  start = tic ();
  limit = str2double (getenv ('DECALIOC_TEST_LIMIT'));
  if ~isfinite (limit)
    limit = 900 * (1 + 7 * strcmp (getenv ('DECALIOC_SOAK'), '1'));
  end
  tool = shellQuote (fullfile (root, 'tests', 'endTests.sh'));
  [~, guard] = system (sprintf (['setsid bash %s %d %d %s %s > /dev/null 2>&1 ', ...
                                 '& echo $!'], tool, limit, getpid (), ...
                                getenv ('TMPDIR'), note));
  log = tempname ();
  % a function of an example or a model is found by its own test only, as are
  % the private ones of its folder; the path is set anew only where it has
  % changed, which takes a tenth of a second
  before = path ();
  folder = fileparts (file);
  folders = {folder, fullfile(folder, 'private')};
  isNew = cellfun (@isfolder, folders) & ...
          ~ismember (folders, strsplit (before, pathsep ()));
  if any (isNew)
    addpath (folders{isNew}, '-end');
  end
  fid = fopen (log, 'w');
  [passed, total, ~, skipped] = test (file, 'quiet', fid);
  fclose (fid);
  system (['kill -- -', strtrim(guard), ' 2> /dev/null']);
  if any (isNew)
    rmpath (folders{isNew});
  end
  if ~strcmp (path (), before)
    path (before);
  end
  counts = [passed, total - passed, skipped];
  text = sprintf ("%-56s %3d of %3d  %4.0f s\n", ...
                  strrep (file, [root, '/'], ''), passed, total, toc (start));
  if any (counts(2:3) > 0)
    text = [text, fileread(log)];
  end
  puts (text);
  fflush (stdout ());
  unlink (log);
end

% Flows that start a batch system go one after another. Every Octave says on
% leaving that it ignores something, which is no news.
function found = shareOut (root, files, ifTime)
  hasQueue = ~cellfun (@isempty, regexp (files, '/(executors|slurm\w*)\.tst$'));
  files(ifTime) = strcat ('?', files(ifTime));
  files = [{strjoin(files(hasQueue), "\t")}, files(~hasQueue)];
  files = files(~cellfun (@isempty, files));
  queue = tempname ();
  mkdir (queue);
  minutes = str2double (getenv ('MINUTES'));
  minutes(isnan (minutes)) = Inf;
  saveText (fullfile (queue, 'deadline'), ...
            sprintf ('%.0f', time () + 60 * minutes));
  saveText (fullfile (queue, 'files'), strjoin (files, "\n"));
  tool = shellQuote (fullfile (root, 'tools', 'octave.sh'));
  % one that was killed is followed by another, for the files that are left
  one = sprintf (['{ while %s tests/runTests.m --queue %s; [ $? -gt 1 ]; ', ...
                  'do :; done 2>&1 | %s; }'], tool, queue, ...
                 'grep --line-buffered -v "^error: ignoring const"');
  % one more than there are cores, as the flows wait for clocks now and then
  n = min ([nproc() + 1, 4, numel(files)]);
  system ([strjoin(repmat ({one}, 1, n), ' & '), ' & wait']);
  found = gather (queue, files, root);
  rmdir (queue, 's');
end

% FOUND: struct; counts (passed, failed, skipped), failing (cell of files), said
% (text of the failures), late (text: files that were not begun).
function found = gather (queue, files, root)
  found = struct ('counts', zeros (1, 3), 'failing', {{}}, 'said', '', ...
                  'late', '');
  files = strrep (strrep (files, '?', ''), [root, '/'], '');
  for k = 1:numel (files)
    claim = fullfile (queue, sprintf ('%d', k));
    counts = [0, 1, 0];
    text = sprintf ("%s: its Octave ended in the middle\n", files{k});
    if isfile (fullfile (claim, 'limit'))
      text = sprintf ("%s: %s", files{k}, fileread (fullfile (claim, 'limit')));
    elseif isfile (fullfile (claim, 'counts'))
      counts = sscanf (fileread (fullfile (claim, 'counts')), '%d')';
      text = fileread (fullfile (claim, 'failed'));
      found.late = [found.late, fileread(fullfile (claim, 'late'))];
    end
    found.counts = found.counts + counts;
    if counts(2) > 0
      found.said = [found.said, text];
      found.failing{end + 1} = files{k};
    end
  end
end

history_save (false);
confirm_recursive_rmdir (false);
addpath (fullfile (fileparts (fileparts (mfilename ('fullpath'))), ...
                   'benchmarks'));
root = startBenchmarks ();
args = argv ()';
scratch = tempname ();
mkdir (scratch);
setenv ('TMPDIR', scratch);
home = cd (scratch);
failed = 0;
if numel (args) > 1 && strcmp (args{end - 1}, '--queue')
  runQueue (root, args{end});
else
  [files, ifTime] = testFiles (root, strjoin (args));
  found = shareOut (root, files, ifTime);
  if ~isempty (found.failing)
    % once more: a log that is cut keeps its end
    printf ("\nFailed: %s\n%s", strjoin (found.failing, ', '), found.said);
  end
  if ~isempty (found.late)
    printf ("\nNot begun, MINUTES=%s were over:%s\n", getenv ('MINUTES'), ...
            found.late);
  end
  failed = found.counts(2);
  skipped = repmat (sprintf (', %d skipped', found.counts(3)), 1, ...
                    found.counts(3) > 0);
  printf ("%d passed, %d failed%s\n", found.counts(1:2), skipped);
end
cd (home);
rmdir (scratch, 's');
exit (double (failed > 0));

% SPDX-License-Identifier: GPL-3.0-only
