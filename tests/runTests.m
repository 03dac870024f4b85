% RUNTESTS  Runs the tests of all functions and all flows.
%
% CALL: octave-cli tests/runTests.m [PATTERN]
%
%   PATTERN  run only the files whose path holds this text
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

% Those that kill programs or start a service of the machine have it to
% themselves.
function yes = needsQuiet (file)
  [~, name] = fileparts (file);
  yes = ~isempty (regexp (name, '^(slurm|faults|executors|commandKilled)'));
end

% The other ones by as many workers as there are processors, one file after the
% other for each.
function counts = runAll (files, root)
  isQuiet = cellfun (@needsQuiet, files);
  beside = files(~isQuiet);
  alone = files(isQuiet);
  n = min (nproc (), numel (beside));
  if n < 2
    alone = files;
    beside = {};
  end
  counts = zeros (0, 3);
  if ~isempty (beside)
    lines = parcellfun (n, @(f) runTestFile (f, root), beside, ...
                        'UniformOutput', false, 'VerboseLevel', 0);
    counts = vertcat (lines{:});
  end
  for k = 1:numel (alone)
    counts(end + 1, :) = runTestFile (alone{k}, root);
  end
  names = [beside, alone];
  failing = strrep (names(counts(:, 2) > 0), [root, '/'], '');
  if ~isempty (failing)
    printf ('Failed, see above: %s\n', strjoin (failing, ', '));
  end
end

history_save (false);
addpath (fullfile (fileparts (fileparts (mfilename ('fullpath'))), ...
                   'benchmarks'));
root = startBenchmarks ();
args = argv ();
pattern = '';
if ~isempty (args)
  pattern = args{end};
end
scratch = tempname ();
mkdir (scratch);
setenv ('DECALIOC_SCRATCH', scratch);
home = cd (scratch);
counts = sum (runAll (testFiles (root, pattern), root), 1);
cd (home);
confirm_recursive_rmdir (false);
rmdir (scratch, 's');
if counts(3) > 0
  printf ('%d passed, %d failed, %d skipped\n', counts);
else
  printf ('%d passed, %d failed\n', counts(1:2));
end
exit (double (counts(2) > 0));
