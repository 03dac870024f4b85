% BIGLIBRARY  Start of a case on a store that holds many runs.
%
% CALL: octave-cli benchmarks/bigLibrary.m [RUNS]
%
% RUNS (default 100000) records of the stand-in 'plain' (1 % noise) are written
% into a new store: no run is made. Printed are the seconds and the memory of
% libraryRuns without an index (all records are read), with it (in a fresh
% Octave), and what is lost by learning of a part of the runs: the error of the
% surrogates where the responses are within 5 % of the targets, in % of them,
% for 100, 300 and 1000 runs.
%
% See also: libraryRuns, nearRows, materials

1;

function mb = mostMemory ()
  text = fileread ('/proc/self/status');
  mb = str2double (regexp (text, 'VmHWM:\s+(\d+)', 'tokens', ...
                           'once'){1}) / 1024;
end

function Case = plainCase (folder, S)
  model = fullfile (folder, 'DEMmodels', 'First');
  if ~isfolder (model)
    standInCase (folder);
    lines = cellfun (@(n) sprintf ("variable %s equal 1\n", n), S.names, ...
                     'UniformOutput', false);
    file = fullfile (model, 'data.head');
    writeAtomic (file, [fileread(file), lines{:}]);
  end
  Input = struct ('model', {{'First'}}, 'cpu', 1, 'maxCPU', 1, 'numOfSam', ...
                  8, 'store', fullfile (folder, 'store'));
  raw = struct ('Input', Input, 'modelVars', struct (), 'folder', folder, ...
                'paramLims', S.limits, 'root', ...
                fileparts (fileparts (which ('startToolbox'))));
  raw.optim = struct ('targetVal', {{S.value}}, 'tolRes', 0.01);
  raw.assign = S.names;
  Case = newCase (raw);
end

function writeRuns (Case, S, n)
  place = fullfile (Case.store, 'optim', 'First');
  mkdir (Case.store);
  mkdir (fullfile (Case.store, 'optim'));
  mkdir (place);
  system (sprintf ('cd %s && seq -f %%04.0f %d | xargs mkdir', ...
                   shellQuote (place), n));
  rand ('twister', 1);
  randn ('twister', 1);
  h = hashModels (Case);
  width = diff (S.limits);
  P = S.limits(1, :) + (2 * rand (n, columns (width)) - 0.5) .* width;
  Z = S.response (P) .* (1 + S.noise * randn (n, numel (S.value)));
  job = newJobs (Case, P(1, :), [], 1, 'plan');
  for i = 1:n
    job.params = P(i, :);
    job.seed = 10007 + i;
    [job.key, ~, job.variables] = runKey (runVariables (job, Case), {}, h);
    job.origin = sprintf ('/cases/%d', mod (i, 50));
    r = newRecord (job, '');
    [r.status, r.results, r.seconds, r.funs] = ...
      deal ('ok', Z(i, :), 100, h.funs);
    names = fieldnames (r);
    for k = find (~structfun (@ischar, r))'
      r.(names{k}) = strtrim (sprintf ('%.17g ', r.(names{k})));
    end
    body = jsonencode (r);
    fid = fopen (fullfile (place, sprintf ('%04d', i), 'record.json'), 'w');
    fprintf (fid, '{"sha256":"%s","record":%s}\n', hash ('sha256', body), body);
    fclose (fid);
  end
end

function look (Case, what)
  problem = newProblem (Case);
  started = tic ();
  [data, told] = libraryRuns (Case, problem, true);
  printf ('%-14s %6.1f s, at most %4.0f MB, %d rows taken\n', what, ...
          toc (started), mostMemory (), rows (data.X));
end

function sayLost (Case, S)
  problem = newProblem (Case);
  none = repmat ({zeros(0, 1)}, 1, 1);
  found = familyRuns (Case, hashModels (Case), none);
  table = addRows (newData (numel (S.names), numel (S.value)), found.inputs, ...
                   found.Z, ones (rows (found.Z), 1), 'library');
  X = S.limits(1, :) + rand (20000, numel (S.names)) .* diff (S.limits);
  truth = S.response (X);
  near = all (abs (truth ./ S.value - 1) < 0.05, 2);
  for most = [100, 300, 1000]
    use = thinRuns (table, problem, most);
    started = tic ();
    s = fitSurrogates (keepRows (table, use), problem);
    seconds = toc (started);
    off = predictSurrogate (s, X(near, :)) ./ truth(near, :) - 1;
    printf ('%5d runs: error %.2f %% and %.2f %% (rms), fit %.1f s\n', most, ...
            100 * sqrt (mean (off.^2, 1)), seconds);
  end
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
startBenchmarks ();
S = standIn ('plain');
folder = getenv ('DECALIOC_BIGLIBRARY');
if isempty (folder)
  n = str2double ([argv(); {'100000'}]{1});
  folder = tempname ();
  Case = plainCase (folder, S);
  writeRuns (Case, S, n);
  look (Case, 'no index');
  setenv ('DECALIOC_BIGLIBRARY', folder);
  system (['octave-cli --no-history ', ...
           shellQuote([mfilename('fullpath'), '.m'])]);
  sayLost (Case, S);
  confirm_recursive_rmdir (false, 'local');
  rmdir (folder, 's');
else
  look (plainCase (folder, S), 'with its index');
end
