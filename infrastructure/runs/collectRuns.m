% COLLECTRUNS  Makes run records of simulations that have ended.
%
% CALL: RECORDS = collectRuns (JOBS, FOLDERS, CASE, APART)
%
%   JOBS     1 x n struct array, see newJobs
%   FOLDERS  1 x n cell of run folders, each with an end mark
%   CASE     see newCase
%   APART    evaluate in workers of parcellfun (default) or, where this is a
%            worker already, right here (false)
%   RECORDS  1 x n struct array, see newRecord; also in the folders
%
% An exit status of 0 does not prove that LIGGGHTS succeeded (lost particles,
% a signal, a truncated input all give 0), so its output is looked at as well.
% getResults is the user's: it runs in workers of parcellfun, which it may
% bring down without harm to the calibration. It may take as long as its model's
% Input.timeout; without it 20 times as long as the simulation, at least 10
% minutes.
%
% See also: evaluateRun, readEndMark

function records = collectRuns (jobs, folders, Case, apart)
  n = numel (jobs);
  todo = cell (1, n);
  places = cell (1, n);
  for i = 1:n
    k = find (strcmp (jobs(i).model, {Case.models.name}));
    [~, name] = fileparts (folders{i});
    funs = fullfile (Case.models(k).folder, 'OctaveFuns');
    places{i} = struct ('base', Case.store, 'name', name, 'funs', funs, ...
                        'count', Case.models(k).nTargets, 'limit', Inf);
    if isfield (Case.models, 'readings') && ~isempty (Case.models(k).readings)
      places{i}.readings = Case.models(k).readings;
      places{i}.info = resultInfo (Case.models(k).folder);
    end
    todo{i} = judgeEnd (newRecord (jobs(i), folders{i}));
    if nargin < 4 || apart
      places{i}.limit = evaluationLimit (Case.models(k), todo{i});
    end
    todo{i}.funs = hashOfFuns (Case.models(k));
  end
  if nargin > 3 && ~apart
    records = cellfun (@evaluateRun, todo, places, 'UniformOutput', false);
  else
    records = evaluateAll (todo, places);
  end
  records = [records{:}];
end

function key = hashOfFuns (model)
  if isfield (model, 'funs')
    key = model.funs;
  else
    key = hashEvaluation (model);
  end
end

function seconds = evaluationLimit (model, record)
  seconds = model.timeout;
  if isnan (seconds)
    seconds = max (600, 20 * record.seconds);
  end
end

function records = evaluateAll (todo, places)
  % of an earlier evaluation: it says nothing of this one
  [~] = cellfun (@(r) unlink (lateMark (r)), todo);
  try
    records = inWorkers (todo, places);
  catch
    records = cellfun (@evaluateAlone, todo, places, 'UniformOutput', false);
  end
end

function records = inWorkers (todo, places)
  records = parcellfun (min (numel (todo), nproc ()), @evaluateRun, todo, ...
                        places, 'UniformOutput', false, 'VerboseLevel', 0);
end

% After its worker has gone down: once more, unless its time was up.
function record = evaluateAlone (todo, place)
  reason = '';
  if ~wasLate (todo)
    try
      record = inWorkers ({todo}, {place}){1};
      return
    catch
      reason = ['getResults ended the Octave that ran it (or the record ' ...
                'could not be written)'];
    end
  end
  if wasLate (todo)
    reason = sprintf (['getResults had not ended after %g s, its limit ' ...
                       '(Input.timeout, or 20 times the simulation)'], ...
                      place.limit);
  end
  record = failedRecord (todo, todo.folder, 'invalid', reason, 'output');
end

function yes = wasLate (record)
  yes = isfile (lateMark (record));
end

function file = lateMark (record)
  file = fullfile (record.folder, 'getResults.late');
end

function record = judgeEnd (record)
  mark = readEndMark (record.folder);
  record.seconds = mark.seconds;
  said = tailOf (fullfile (record.folder, 'stdout.txt'));
  wasStopped = ~isempty (strfind (said, 'SIGINT/SIGTERM caught'));
  if strcmp (mark.reason, 'timeout')
    record = blame (record, 'timeout', 'time', ...
                    sprintf ('ended at its time limit after %g s', ...
                             mark.seconds));
  elseif strcmp (mark.reason, 'killed') || wasStopped || fromOutside (mark)
    record = blame (record, 'failed', 'killed', ...
                    sprintf ('ended from outside (exit status %d)', ...
                             mark.code));
  elseif mark.code ~= 0
    record = blame (record, 'failed', 'exit', ...
                    sprintf ('exit status %d', mark.code));
  elseif ~hasEndLine (record.folder, said)
    record = blame (record, 'failed', 'exit', ...
                    'its input did not run to the last line');
  else
    record.status = 'ok';
  end
end

% Ended by HUP, INT, KILL or TERM. A crash (SEGV, ABRT, FPE) is the program's
% own and would come again with the same seed.
function yes = fromOutside (mark)
  yes = ismember (mark.code, 128 + [1, 2, 9, 15]);
end

function record = blame (record, status, cause, message)
  record.status = status;
  record.cause = cause;
  said = [tailOf(fullfile (record.folder, 'stdout.txt')), ...
          tailOf(fullfile (record.folder, 'stderr.txt'))];
  complaint = regexp (said, '^.*(ERROR|rror:|not found).*$', 'match', ...
                      'once', 'lineanchors', 'dotexceptnewline');
  if isempty (complaint)
    lines = strsplit (strtrim (said), "\n");
    complaint = lines{end};
  end
  record.message = strtrim (sprintf ('%s; %s', message, complaint));
end

% Models of this toolbox print RUN COMPLETE in the last line of their input.
function yes = hasEndLine (folder, said)
  yes = true;
  names = readdir (folder);
  inputs = names(strncmp (names, 'in.', 3));
  texts = cellfun (@(f) fileread (fullfile (folder, f)), inputs, ...
                   'UniformOutput', false);
  promises = ~all (cellfun (@isempty, strfind (texts, 'RUN COMPLETE')));
  if promises
    said = [said, tailOf(fullfile (folder, 'log.liggghts'))];
    yes = ~isempty (regexp (said, '^RUN COMPLETE\s*$', 'once', ...
                            'lineanchors'));
  end
end

function text = tailOf (file)
  text = '';
  fid = fopen (file, 'r');
  if fid >= 0
    fseek (fid, 0, 'eof');
    fseek (fid, max (0, ftell (fid) - 4000), 'bof');
    text = fread (fid, Inf, 'uint8=>char')';
    fclose (fid);
  end
  % regexp throws at half a character, or at one of another encoding
  text(double (text) > 127) = '?';
end

%!test
%! % a getResults that hangs is ended at the model's limit, the others count
%! Case = newCase (standInCase (tempname ()));
%! funs = fullfile (Case.models(2).folder, 'OctaveFuns', 'getResults.m');
%! writeAtomic (funs, ["function res = getResults (model, name)\n", ...
%!                     "pause (100)\nres = {1};\nend\n"]);
%! Case.models(2).timeout = 2;
%! [Z, records] = evaluateDEM ([1, 2], Case);
%! assert (Z, [3, 2, NaN], 1e-12);
%! assert (records(2).status, 'invalid');
%! assert (~isempty (strfind (records(2).message, 'not ended after 2 s')));
%!test
%! % a worker that is killed in getResults: evaluated again, at once; the watch
%! % over its time limit once held the caller for all of it, then said it had
%! % been late
%! Case = newCase (standInCase (tempname ()));
%! funs = fullfile (Case.models(2).folder, 'OctaveFuns', 'getResults.m');
%! writeAtomic (funs, ["function res = getResults (model, name)\n", ...
%!                     "global path\n", ...
%!                     "mark = [path, 'optim/', model, '/', name, ", ...
%!                     "'/seen'];\n", ...
%!                     "if ~isfile (mark)\n", ...
%!                     "  fclose (fopen (mark, 'w'));\n", ...
%!                     "  kill (getpid (), 9);\nend\nres = {7};\nend\n"]);
%! Case.models(2).timeout = 20;
%! [Z, records] = evaluateDEM ([1, 2], Case);
%! assert (Z, [3, 2, 7], 1e-12);
%! assert (records(2).status, 'ok');
%!test
%! % a crash is a failure of the run itself, a kill is not
%! Case = newCase (standInCase (tempname ()));
%! run = fullfile (Case.models(2).folder, 'runscript');
%! causes = {};
%! for sign = {'SEGV', 'ABRT', 'KILL', 'TERM'}
%!   writeAtomic (run, ["kill -", sign{1}, " $$\nsleep 5\n"]);
%!   job = newJobs (Case, [1, 2], [], numel (causes) + 1, 'plan')(2);
%!   causes{end + 1} = executeLocal (job, Case, @(s) []).cause;
%! end
%! assert (causes, {'exit', 'exit', 'killed', 'killed'});
%!test
%! % output in any encoding, cut in the middle of a character; a folder whose
%! % name means something to glob
%! store = fullfile (tempname (), 'Versuch [2]');
%! Case = newCase (standInCase (store));
%! model = Case.models(2).folder;
%! run = fullfile (model, 'runscript');
%! writeAtomic (fullfile (model, 'in.toy'), "print \"RUN COMPLETE\"\n");
%! say = "for i in {1..3000}; do printf '\\303\\274'; done; echo x\n";
%! finish = "echo 1 > out\necho RUN COMPLETE\n";
%! endings = {finish, "echo 1 > out\n", "printf 'ERROR: \\374\\n'; exit 1\n"};
%! status = cell (1, 3);
%! for k = 1:3
%!   writeAtomic (run, [say, endings{k}]);
%!   job = newJobs (Case, [1, 2], [], k, 'plan')(2);
%!   status{k} = executeLocal (job, Case, @(s) []).status;
%! end
%! assert (status, {'ok', 'failed', 'failed'});
