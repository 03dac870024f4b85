% BIGSTORE  A store that holds many runs: listing it, starting a case on it.
%
% CALL: octave-cli benchmarks/bigStore.m [RUNS]
%
%   RUNS  number of records (default 100000) of the stand-in 'plain' (1 %
%         noise), of 50 cases; no run is made
%
% Printed are seconds, seconds of processor time and the most memory (MB) of
% readLibrary where there is no index (all records are read), of readLibrary and
% of libraryRuns (the start of a new case) where there is one, each in a fresh
% Octave, and of decalioc check.
%
% See also: readLibrary, libraryRuns

1;

function Case = plainCase (folder, S)
  model = fullfile (folder, 'DEMmodels', 'First');
  if ~isfolder (model)
    standInCase (folder);
    lines = cellfun (@(n) sprintf ("variable %s equal 1\n", n), S.names, ...
                     'UniformOutput', false);
    file = fullfile (model, 'data.head');
    writeAtomic (file, [fileread(file), lines{:}]);
    names = sprintf ('''%s'', ', S.names{:});
    lines = {['function [Input, optim, modelVars, assign, paramLims] = ', ...
              'loadInput ()'], ...
             'Input.model = {''First''}; Input.cpu = 1; Input.maxCPU = 1;', ...
             'Input.numOfSam = 8;', ...
             'Input.store = fullfile (pwd (), ''store'');', ...
             sprintf('optim.targetVal = {%s};', mat2str (S.value, 17)), ...
             'optim.tolRes = 0.01; modelVars = struct ();', ...
             sprintf('assign = {%s};', names(1:end - 2)), ...
             sprintf('paramLims = %s;', mat2str (S.limits, 17)), 'end'};
    writeAtomic (fullfile (folder, 'loadInput.m'), strjoin (lines, "\n"));
  end
  here = cd (folder);
  back = onCleanup (@() cd (here));
  Case = loadCase (fileparts (fileparts (which ('startToolbox'))), folder);
end

% A record is that of the first one with other numbers: a hundredth of the time.
function writeRuns (Case, S, n)
  place = fullfile (Case.store, 'optim', 'First');
  [~, ~] = mkdir (Case.store);
  [~, ~] = mkdir (fileparts (place));
  [~, ~] = mkdir (place);
  system (sprintf ('cd %s && seq -f %%04.0f %d | xargs mkdir', ...
                   shellQuote (place), n));
  rand ('twister', 1);
  randn ('twister', 1);
  h = hashModels (Case);
  width = diff (S.limits);
  U = 2 * rand (n, columns (width)) - 0.5;
  P = toDigits (S.limits(1, :) + U .* width);
  Z = S.response (P) .* (1 + S.noise * randn (n, numel (S.value)));
  job = newJobs (Case, P(1, :), [], 1, 'plan');
  values = strjoin (repmat ({'%.17g'}, 1, numel (S.names)), ' ');
  form = regexprep (job.variables, '=[^|]*', '=%.17g');
  order = regexp (job.variables, '\w+(?==)', 'match');
  [~, order] = ismember (order, [S.names, {'runSeed'}]);
  job = setfield (job, 'owner', repmat ('%c', 1, 32));
  r = newRecord (job, '');
  [r.params, r.seed, r.key, r.variables, r.results] = ...
    deal (values, '%d', '%s', '%s', '%.17g %.17g');
  [r.status, r.seconds, r.funs, r.planRow, r.replicate, r.effects] = ...
    deal ('ok', '100', h.funs, '1', '1', '');
  body = jsonencode (r);
  for i = 1:n
    seed = 10007 + i;
    all_ = [P(i, :), seed];
    text = sprintf (form, all_(order));
    owner = sprintf ('%032x', mod (i, 50) + 1);
    record = sprintf (body, P(i, :), seed, hash ('sha256', [h.input, text]), ...
                      text, owner, Z(i, :));
    fid = fopen (sprintf ('%s/%04d/record.json', place, i), 'w');
    fprintf (fid, '{"sha256":"%s","record":%s}\n', hash ('sha256', record), ...
             record);
    fclose (fid);
  end
end

function look (what, f)
  [wall, cpu] = deal (time (), cputime ());
  n = f ();
  memory = regexp (fileread ('/proc/self/status'), 'VmHWM:\s+(\d+)', ...
                   'tokens', 'once'){1};
  printf (['%-26s %6.1f s, %6.1f s of processor time, %5.0f MB, %d ' ...
           'runs\n'], what, time () - wall, cputime () - cpu, ...
          str2double (memory) / 1024, n);
  fflush (stdout);
end

function n = listed (Case)
  kinds = readLibrary (Case.store, 'First', hashModels (Case)(1));
  n = sum (cellfun (@rows, {kinds.runs}));
end

function n = taken (Case)
  data = libraryRuns (Case, newProblem (Case), true);
  n = rows (data.X);
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
S = standIn ('plain');
again = getenv ('DECALIOC_BIGSTORE');
if ~isempty (again)
  [folder, what] = strtok (again, "\n");
  steps = struct ('listing', @listed, 'start', @taken);
  f = steps.(strtok (what(2:end), ' '));
  look (what(2:end), @() f (plainCase (folder, S)));
  exit (0);
end
words = [argv()', {'100000'}];
folder = tempname ();
Case = plainCase (folder, S);
writeRuns (Case, S, str2double (words{1}));
self = shellQuote ([mfilename('fullpath'), '.m']);
for what = {'listing without an index', 'listing with it', ...
            'start of a new case'}
  setenv ('DECALIOC_BIGSTORE', [folder, "\n", what{1}]);
  system (['octave-cli --no-history ', self]);
end
act = sprintf ('cd %s && time -p %s check', shellQuote (folder), ...
               shellQuote (fullfile (root, 'bin', 'decalioc')));
[~, said] = system (['bash -c ', shellQuote(act), ' 2>&1 | tail -n 3']);
printf ('decalioc check: %s\n', strrep (strtrim (said), "\n", ', '));
confirm_recursive_rmdir (false, 'local');
rmdir (folder, 's');
