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
setenv ('TMPDIR', scratch);
home = cd (scratch);
counts = zeros (1, 3);
failing = {};
files = testFiles (root, pattern);
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
