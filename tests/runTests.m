% RUNTESTS  Runs the tests of all functions and all flows.
%
% CALL: octave-cli tests/runTests.m [PATTERN]
%       octave-cli tests/runTests.m --part K N
%
%   PATTERN  run only the files whose path holds this text
%   --part   every N-th file from the K-th on of those that are no flow
%
% Without a pattern the tests of functions are run by an Octave for each core,
% then the flows (*.tst) one by one: these use all cores themselves.
%
% The last line reads: N passed, N failed. The exit status is 1 if any failed.
% With DECALIOC_SOAK=1 in the environment the long tests run too.

1;

function files = testFiles (root, pattern)
  [~, list] = system (['cd ', shellQuote(root), ' && find "$PWD" ', ...
                       '\( -name optim -o -name .git \) -prune -o ', ...
                       '\( -name "*.m" -o -name "*.tst" \) -print | sort']);
  files = strsplit (strtrim (list), "\n");
  hasTests = @(f) ~isempty (regexp (fileread (f), '^%!', 'once', ...
                                    'lineanchors'));
  files = files(cellfun (hasTests, files));
  if ~isempty (pattern)
    files = files(~cellfun (@isempty, strfind (files, pattern)));
  end
end

function [passed, failed, skipped] = runFile (file, root)
  start = tic ();
  log = tempname ();
  % a function of an example or a model is found by its own test only
  before = addpath (fileparts (file), '-end');
  fid = fopen (log, 'w');
  [passed, total, ~, skipped] = test (file, 'quiet', fid);
  fclose (fid);
  path (before);
  failed = total - passed;
  printf ('%-56s %3d of %3d  %4.0f s\n', strrep (file, [root, '/'], ''), ...
          passed, total, toc (start));
  if failed > 0 || skipped > 0
    puts (fileread (log));
  end
  fflush (stdout ());
  unlink (log);
end

% Every share by an Octave of its own.
function [counts, failing] = runParts (root, n)
  tool = shellQuote (fullfile (root, 'tools', 'octave.sh'));
  show = 'grep --line-buffered -vE "^([0-9]+ passed|Failed, see|error: ign)"';
  logs = arrayfun (@(k) [tempname(), '.log'], 1:n, 'UniformOutput', false);
  each = arrayfun (@(k) sprintf ('(%s %s %d %d 2>&1 | tee %s | %s)', tool, ...
                                 'tests/runTests.m --part', k, n, logs{k}, ...
                                 show), ...
                   1:n, 'UniformOutput', false);
  system ([strjoin(each, ' & '), ' & wait']);
  counts = zeros (1, 3);
  failing = {};
  for k = 1:n
    said = fileread (logs{k});
    unlink (logs{k});
    last = regexp (said, '^\d+ passed, .*$', 'match', 'lineanchors', ...
                   'dotexceptnewline');
    if isempty (last)
      last = {'0 passed, 1 failed'};       % it ended before its last line
      failing{end + 1} = sprintf ('part %d of %d', k, n);
    end
    last = sscanf (last{end}, '%d passed, %d failed, %d skipped')';
    counts(1:numel (last)) = counts(1:numel (last)) + last;
    names = regexp (said, '^Failed, see above: (.*)$', 'tokens', ...
                    'lineanchors', 'dotexceptnewline');
    failing = [failing, names{:}];
  end
end

history_save (false);
addpath (fullfile (fileparts (fileparts (mfilename ('fullpath'))), ...
                   'benchmarks'));
root = startBenchmarks ();
args = argv ()';
at = find (strcmp (args, '--part'));
isPart = ~isempty (at);
pattern = '';
if ~isPart && ~isempty (args)
  pattern = args{end};
end
files = testFiles (root, pattern);
isFlow = ~cellfun (@isempty, regexp (files, '\.tst$'));
counts = zeros (1, 3);
failing = {};
if isPart
  files = files(~isFlow);
  files = files(str2double (args{at + 1}):str2double (args{at + 2}):end);
elseif isempty (args)
  [counts, failing] = runParts (root, nproc ());
  files = files(isFlow);
end
scratch = tempname ();
mkdir (scratch);
setenv ('TMPDIR', scratch);
home = cd (scratch);
for k = 1:numel (files)
  [p, f, s] = runFile (files{k}, root);
  counts = counts + [p, f, s];
  if f > 0
    failing{end + 1} = strrep (files{k}, [root, '/'], '');
  end
end
cd (home);
confirm_recursive_rmdir (false);
rmdir (scratch, 's');
if ~isempty (failing)
  printf ('Failed, see above: %s\n', strjoin (failing, ', '));
end
if counts(3) > 0
  printf ('%d passed, %d failed, %d skipped\n', counts);
else
  printf ('%d passed, %d failed\n', counts(1:2));
end
exit (double (counts(2) > 0));
