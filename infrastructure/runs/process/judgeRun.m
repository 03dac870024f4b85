% JUDGERUN  Says how a simulation ended, and how its results are to be read.
%
% CALL: [RECORD, PLACE] = judgeRun (JOB, FOLDER, CASE)
%
%   JOB     see newJobs
%   FOLDER  run folder with an end mark
%   CASE    see newCase; store, models and hashes (see hashModels) are read
%   RECORD  see newRecord, with the status 'ok' where getResults can be called
%   PLACE   see evaluateRun; its limit is the model's Input.timeout, without it
%           20 times as long as the simulation took, at least 10 minutes
%
% An exit status of 0 does not prove that LIGGGHTS succeeded (lost particles,
% a signal, a truncated input all give 0), so its output is looked at as well.

function [record, place] = judgeRun (job, folder, Case)
  k = find (strcmp (job.model, {Case.models.name}));
  model = Case.models(k);
  [~, name] = fileparts (folder);
  record = judgeEnd (newRecord (job, folder));
  record.funs = hashModels (Case)(k).funs;
  place = struct ('base', fileparts (runPlace (Case)), 'name', name, ...
                  'funs', fullfile (model.folder, 'OctaveFuns'), ...
                  'count', model.nTargets, 'limit', model.timeout);
  if isnan (place.limit)
    place.limit = max (600, 20 * record.seconds);
  end
  if ~isempty (model.readings)
    place.readings = model.readings;
    place.info = resultInfo (model.folder);
  end
end

function record = judgeEnd (record)
  mark = readEndMark (record.folder);
  record.seconds = mark.seconds;
  output = tailOf (fullfile (record.folder, 'stdout.txt'));
  wasStopped = ~isempty (strfind (output, 'SIGINT/SIGTERM caught'));
  if strcmp (mark.reason, 'timeout')
    record = blame (record, 'timeout', 'time', ...
                    sprintf ('ended at its time limit after %g s', ...
                             mark.seconds));
  elseif strcmp (mark.reason, 'killed') || wasStopped
    record = blame (record, 'failed', 'killed', ...
                    sprintf ('ended from outside (exit status %d)', ...
                             mark.code));
  elseif mark.code ~= 0
    record = blame (record, 'failed', 'exit', ...
                    sprintf ('exit status %d', mark.code));
  elseif ~hasEndLine (record.folder, output)
    record = blame (record, 'failed', 'exit', ...
                    'its input did not run to the last line');
  else
    record.status = 'ok';
  end
end

function record = blame (record, status, cause, message)
  record.status = status;
  record.cause = cause;
  output = [tailOf(fullfile (record.folder, 'stdout.txt')), ...
            tailOf(fullfile (record.folder, 'stderr.txt'))];
  complaint = regexp (output, '^.*(ERROR|rror:|not found).*$', 'match', ...
                      'once', 'lineanchors', 'dotexceptnewline');
  if isempty (complaint)
    lines = strsplit (strtrim (output), "\n");
    complaint = lines{end};
  end
  record.message = regexprep (sprintf ('%s; %s', message, complaint), ...
                              ';?\s*$', '');
end

% Models of this toolbox print RUN COMPLETE in the last line of their input.
function yes = hasEndLine (folder, output)
  yes = true;
  names = readdir (folder);
  inputs = names(strncmp (names, 'in.', 3));
  texts = cellfun (@(f) fileread (fullfile (folder, f)), inputs, ...
                   'UniformOutput', false);
  promises = ~all (cellfun (@isempty, strfind (texts, 'RUN COMPLETE')));
  if promises
    output = [output, tailOf(fullfile (folder, 'log.liggghts'))];
    yes = ~isempty (regexp (output, '^RUN COMPLETE\s*$', 'once', ...
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
%! % a crash is a failure of the run itself, a kill is not
%! Case = readyCase ();
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

% SPDX-License-Identifier: GPL-3.0-only
