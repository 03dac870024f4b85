% RUNTESTFILE  Runs the tests of one file (a job of runTests).
%
% CALL: COUNTS = runTestFile (FILE, ROOT)
%
%   FILE    path of a function or of a flow with %! blocks
%   ROOT    folder of the toolbox
%   COUNTS  1 x 3: passed, failed, skipped
%
% In a scratch folder of its own, which is the temporary folder too. One line is
% printed, and below it what failed or was skipped.
%
% See also: runTests

function counts = runTestFile (file, root)
  start = tic ();
  startOnce (root);
  scratch = tempname (getenv ('DECALIOC_SCRATCH'));
  mkdir (scratch);
  home = cd (scratch);
  temporary = getenv ('TMPDIR');
  setenv ('TMPDIR', scratch);
  % a function of an example or a model is found by its own test only
  before = addpath (fileparts (file), '-end');
  fid = fopen ('log', 'w');
  [passed, total, ~, skipped] = test (file, 'quiet', fid);
  fclose (fid);
  path (before);
  counts = [passed, total - passed, skipped];
  text = sprintf ('%-56s %3d of %3d  %4.0f s\n', ...
                  strrep (file, [root, '/'], ''), passed, total, toc (start));
  if any (counts(2:3))
    text = [text, fileread(fullfile (scratch, 'log'))];
  end
  puts (text);
  fflush (stdout ());
  cd (home);
  setenv ('TMPDIR', temporary);
  confirm_recursive_rmdir (false, 'local');
  rmdir (scratch, 's');
end

% Once in a process: a worker that is new knows the path, but no package.
function startOnce (root)
  name = 'DECALIOC_TEST_PROCESS';
  if ~strcmp (getenv (name), num2str (getpid ()))
    more ('off');
    addpath (fullfile (root, 'benchmarks'));
    startBenchmarks ();
    setenv (name, num2str (getpid ()));
  end
end
