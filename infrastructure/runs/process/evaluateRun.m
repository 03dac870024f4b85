% EVALUATERUN  Evaluates a finished simulation with the model's getResults.
%
% CALL: RECORD = evaluateRun (RECORD, PLACE)
%
%   RECORD  see newRecord; status 'ok' where the simulation ended well
%   PLACE   struct: base (folder that holds optim/), name (of the run folder),
%           funs (folder of getResults.m), count (how many results), limit
%           (s; then this Octave is killed and getResults.late lies in the
%           run's folder; Inf: no limit); of a case with measured.csv also
%           readings and info, see takeReadings
%   RECORD  with results and status; written to the run's folder
%
% A result that is NaN, Inf (a bin that never runs empty) or [] where others of the run are
% numbers is an outcome: the run is 'ok' (cause 'lacking'), and the others count. Not so
% where the run's own checks (output_checks.csv) find a fault in it. One without any number
% is 'invalid' with the cause 'none': another packing in its place would hide how often that
% happens. A script that ends with another exit status than 0, though results are there
% and nothing says of an error, has failed all the same; the message says what is there,
% and no other packing stands in for it, either ('evaluation').
%
% Runs in a worker of parcellfun, catches everything and returns a record.
% Published evaluation functions build file names from a global variable named
% path: it is set here, around the call of getResults, and nowhere else.

function record = evaluateRun (record, place)
  leaveNoCore ();
  isOk = strcmp (record.status, 'ok');
  if isOk || isQuietExit (record)
    before = {path(), pwd()};
    tried = evaluate (setfield (record, 'status', 'ok'), place);
    if isOk
      record = tried;
    else
      record = afterExit (record, tried, place);
    end
    % the worker goes on with other runs, whatever getResults did to its path
    if ~strcmp (path (), before{1})
      path (before{1});
    end
    if ~strcmp (pwd (), before{2})
      cd (before{2});
    end
  end
  keepRecord (record);
  tidyDrafts (record.folder);
end

function yes = isQuietExit (record)
  yes = strcmp (record.cause, 'exit') && ...
        ~isempty (regexp (record.message, '^exit status (?!12[5-9]|1[3-9]\d|2)', 'once')) && ...
        isempty (regexp (record.message, 'ERROR|rror:|not found', 'once'));
end

% TRIED  as if its exit status had been 0
function record = afterExit (record, tried, place)
  lacks = find (~isfinite (tried.results));
  if numel (lacks) == numel (tried.results)
    return
  end
  record.cause = 'evaluation';
  status = regexp (record.message, '^exit status \d+', 'match', 'once');
  record.message = [status, ', though all its results are there: let runscript end with ' ...
                    'exit 0 if that is no fault'];
  if ~isempty (lacks)
    record.message = [status, '; ', namesOf(lacks, tried.results, place), ', the others ' ...
                      'are there. If nothing flows then, that is an outcome and no fault: ' ...
                      'let getResults return 0 for it, and runscript end with exit 0'];
  end
end

% Octave cannot interrupt its own call: a shell kills the process when the time
% is up. It has a session of its own, so that it is ended together with its
% sleep when WATCH goes.
function watch = startWatch (late, limit)
  watch = onCleanup (@() []);
  if isfinite (limit)
    script = fullfile (fileparts (mfilename ('fullpath')), 'watch.sh');
    act = sprintf ('setsid bash %s %d %s %g %s', shellQuote (script), ...
                   getpid (), processStart (getpid ()), limit, ...
                   shellQuote (late));
    [~, pid] = system ([act, ' > /dev/null 2>&1 < /dev/null & echo $!']);
    watch = onCleanup (@() system (['kill -s KILL -- -', strtrim(pid), ...
                                    ' 2> /dev/null']));
  end
end

function record = evaluate (record, place)
  %| pragma Justify (metric, "globals", "published getResults read it");
  global path
  if place.count == 0                    % a stage: its state alone is wanted
    record.results = zeros (1, 0);
    return
  end
  path = [place.base, '/'];
  addpath (place.funs);
  watch = startWatch (fullfile (record.folder, 'getResults.late'), place.limit);
  % a file that was corrected within the second would not be read again
  clear ('-functions', 'getResults');
  try
    results = getResults (record.model, place.name);
    rmpath (place.funs);                % its helpers shadow nothing of ours
    [record.results, fault] = asRow (results, place);
    record.cause = 'output';
  catch err
    fault = asUtf8 (['getResults gave an error: ', err.message, ...
                     errorPlace(err, place.funs)]);
    if strcmp (err.identifier, 'DEcalioc:getResults:missingFile')
      fault = asUtf8 ([err.message, '. Name the file that it does write in ' ...
                       'OctaveFuns/getResults.m, or call the program that makes it ' ...
                       'in runscript of the model (new --post FILE)']);
    end
    % it would come again with another packing
    record.cause = 'evaluation';
  end
  path = [];
  if isempty (fault)
    record = asOutcome (record, place, checksReason (record.folder));
  else
    record.status = 'invalid';
    record.message = [fault, checksReason(record.folder)];
  end
end

% REASON  what the run's own checks found, '': no fault
function record = asOutcome (record, place, reason)
  lacks = find (~isfinite (record.results));
  record.cause = '';
  if isempty (lacks)
    return
  end
  text = namesOf (lacks, record.results, place);
  record.results(lacks) = NaN;
  if ~isempty (reason)
    record.status = 'invalid';
    record.cause = 'output';
    record.message = [text, ': output is missing or not sane', reason];
  elseif numel (lacks) == numel (record.results)
    record.status = 'invalid';
    record.cause = 'none';
    record.message = [text, ': output is missing or not sane', zeroForNone()];
  else
    record.cause = 'lacking';
    record.message = [text, ', the other results of the run count', zeroForNone()];
  end
end

% A slot that clogs has a rate of 0, and is no fault of the run.
function text = zeroForNone ()
  text = '. Where nothing flows, return 0';
end

function [row, fault] = asRow (results, place)
  fault = '';
  row = [];
  if isfield (place, 'readings')
    [results, fault] = takeReadings (results, place.readings, place.info);
    if ~isempty (fault)
      return
    end
  end
  if isnumeric (results) || islogical (results)
    results = num2cell (results);
  end
  isNumber = @(x) (isnumeric (x) || islogical (x)) && isscalar (x) && ...
                  isreal (x);
  if iscell (results)
    results(cellfun (@(x) isequal (x, []), results)) = NaN;
  end
  if ~iscell (results) || ~all (cellfun (isNumber, results(:)))
    fault = 'getResults must return a cell of real scalars';
    return
  end
  row = double ([results{:}]);
  if numel (row) ~= place.count
    fault = sprintf ('getResults returned %s, %d expected', ...
                     countText (numel (row), 'result'), place.count);
  end
end

% 'result 1 (slope) is NaN', 'results 1 (slope) and 2 (mass) are NaN'
function text = namesOf (lacks, results, place)
  n = numel (results);
  names = arrayfun (@(k) sprintf ('%d%s', k, nameOf (k, n, place)), ...
                    lacks(1:min (end, 3)), 'UniformOutput', false);
  if numel (lacks) > 3
    names{end + 1} = sprintf ('%d more', numel (lacks) - 3);
  end
  what = strjoin (unique (arrayfun (@(x) sprintf ('%g', x), results(lacks), ...
                                    'UniformOutput', false)), ' or ');
  text = ['result ', names{1}, ' is ', what];
  if numel (names) > 1
    text = ['results ', strjoin(names(1:end - 1), ', '), ' and ', names{end}, ' are ', what];
  end
end

% ' (name)' by measured.csv or the results.csv of the model, '' without.
function text = nameOf (k, n, place)
  text = '';
  if isfield (place, 'readings')
    r = place.readings(k);
    text = sprintf (' (%s)', r.result);
    if ~isnan (r.at)
      text = sprintf (' (%s at %g)', r.result, r.at);
    end
    return
  end
  try
    info = resultInfo (fileparts (place.funs));
    if numel (info) == n
      text = sprintf (' (%s)', info(k).name);
    end
  catch
    % a table that cannot be read names nothing
  end
end

% ' (reason)' by output_checks.csv; '' where the run is sane, or its model has
% no such file.
function text = checksReason (folder)
  text = '';
  try
    reason = readChecks (folder).reason;
    text = repmat ([' (', reason, ')'], 1, ~isempty (reason));
  catch
    % a model of one's own need not have checks
  end
end

% Where an error arose, as the user's own files go: ' (getResults.m, line 7)', of the
% innermost of these functions; '' where none is among the callers.
function text = errorPlace (err, folder)
  text = '';
  inside = strfind ({err.stack.file}, folder);
  k = find (~cellfun (@isempty, inside), 1);
  if ~isempty (k)
    [~, base, ending] = fileparts (err.stack(k).file);
    text = sprintf (' (%s%s, line %d)', base, ending, err.stack(k).line);
  end
end

%!test
%! % a result that is not finite: its own checks say why, where there are some
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'getResults.m'), ...
%!              "function r = getResults (model, name)\nr = {NaN};\nend\n");
%! record = setfield (newRecord (standInJob (), folder), 'status', 'ok');
%! place = struct ('base', folder, 'name', '0001', 'funs', folder, ...
%!                 'count', 1, 'limit', Inf);
%! message = @() evaluateRun (record, place).message;
%! plain = 'result 1 is NaN: output is missing or not sane';
%! zero = '. Where nothing flows, return 0';
%! assert (message (), [plain, zero]);
%! lines = @(overlap) sprintf (['spheresStart,10\nspheresOut,4\n', ...
%!                              'spheresEnd,6\nsettled,1\noverlapMax,%g\n'], ...
%!                             overlap);
%! file = fullfile (folder, 'output_checks.csv');
%! writeAtomic (file, lines (0.01));
%! assert (message (), [plain, zero]);
%! writeAtomic (file, lines (0.118));
%! assert (! isempty (strfind (message (), [plain, ' (overlap of 0.118'])));
%! % with a name: of results.csv, of measured.csv
%! unlink (file);
%! funs = fullfile (folder, 'OctaveFuns');
%! mkdir (funs);
%! movefile (fullfile (folder, 'getResults.m'), funs);
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              "name,kind,unit,series,at,text\nslope,angle,deg,,,t\n");
%! place.funs = funs;
%! message = @() evaluateRun (record, place).message;
%! assert (message (), [strrep(plain, 'result 1', 'result 1 (slope)'), zero]);
%! place.info = [];
%! place.readings = struct ('result', 'w', 'series', 'w', 'at', 0.9);
%! put = @(value) writeAtomic (fullfile (funs, 'getResults.m'), ...
%!                             ["function r = getResults (model, name)\n", ...
%!                              "r.w = ", value, ";\nend\n"]);
%! put ('NaN');
%! message = @() evaluateRun (record, place).message;
%! assert (message (), [strrep(plain, 'result 1', 'result 1 (w at 0.9)'), zero]);
%! put ('[0.1, 1; 0.8, 2]');
%! assert (message (), 'w at 0.9 lies beyond the curve (0.1 to 0.8)');
%!test
%! % results are there, though the script ended with another status than 0
%! folder = emptyFolder ();
%! put = @(values) writeAtomic (fullfile (folder, 'getResults.m'), ...
%!   ["function r = getResults (model, name)\nr = ", values, ";\nend\n"]);
%! record = newRecord (standInJob (), folder);
%! [record.status, record.cause, record.message] = deal ('failed', 'exit', 'exit status 1');
%! place = struct ('base', folder, 'name', '0001', 'funs', folder, 'count', 2, 'limit', Inf);
%! put ('{1, 2}');
%! r = evaluateRun (record, place);
%! assert ({r.status, r.cause, r.results}, {'failed', 'evaluation', []});
%! assert (strncmp (r.message, 'exit status 1, though all its results are there', 47));
%! put ('{NaN, 2}');
%! r = evaluateRun (record, place);
%! assert (strncmp (r.message, 'exit status 1; result 1 is NaN, the others are there', 52));
%! put ('{NaN, NaN}');
%! assert ({evaluateRun(record, place).cause, evaluateRun(record, place).message}, ...
%!         {'exit', 'exit status 1'});
%! put ('{1, 2}');
%! for message = {'exit status 1; ERROR: lost atoms', 'exit status 139', 'exit status 127; x'}
%!   record.message = message{1};
%!   assert (evaluateRun (record, place).message, message{1});
%! end
%!test
%! % a run that lacks one result keeps the others; not where its own checks blame it
%! folder = emptyFolder ();
%! put = @(values) writeAtomic (fullfile (folder, 'getResults.m'), ...
%!   ["function r = getResults (model, name)\nr = ", values, ";\nend\n"]);
%! record = setfield (newRecord (standInJob (), folder), 'status', 'ok');
%! place = struct ('base', folder, 'name', '0001', 'funs', folder, 'count', 3, 'limit', Inf);
%! run = @() evaluateRun (record, place);
%! put ('{NaN, 2, 3}');
%! r = run ();
%! assert ({r.status, r.cause, r.results}, {'ok', 'lacking', [NaN, 2, 3]});
%! assert (strncmp (r.message, 'result 1 is NaN, the other results of the run count', 50));
%! assert (readRecord (fullfile (folder, 'record.json')).results, [NaN, 2, 3]);
%! put ('{NaN, NaN, 3}');
%! assert (strncmp (run ().message, 'results 1 and 2 are NaN, the other', 30));
%! put ('{NaN, NaN, NaN}');
%! assert ({run().status, run().cause}, {'invalid', 'none'});
%! put ('{[], -Inf, 3}');
%! r = run ();
%! assert ({r.status, r.cause, r.results}, {'ok', 'lacking', [NaN, NaN, 3]});
%! assert (strncmp (r.message, 'results 1 and 2 are -Inf or NaN, the other', 42));
%! put ('Inf (1, 3)');
%! assert ({run().status, run().cause}, {'invalid', 'none'});
%! put ('{''x'', 2, 3}');
%! assert ({run().status, run().cause}, {'invalid', 'output'});
%! put ('{NaN, 2, 3}');
%! writeAtomic (fullfile (folder, 'output_checks.csv'), ...
%!              ["spheresStart,10\nspheresOut,4\nspheresEnd,6\nsettled,1\n", ...
%!               "overlapMax,0.118\n"]);
%! assert ({run().status, run().cause}, {'invalid', 'output'});
%!test
%! % an error: where it arose, the innermost of the user's own functions
%! folder = emptyFolder ();
%! put = @(name, text) writeAtomic (fullfile (folder, [name, '.m']), text);
%! record = setfield (newRecord (standInJob (), folder), 'status', 'ok');
%! place = struct ('base', folder, 'name', '0001', 'funs', folder, 'count', 1, 'limit', Inf);
%! put ('getResults', "function r = getResults (model, name)\nr = slopeIn (name);\nend\n");
%! told = @() regexp (evaluateRun (record, place).message, ' \(\w+\.m, line \d\)$', 'match');
%! assert (told (), {' (getResults.m, line 2)'});
%! put ('slopeIn', "function r = slopeIn (name)\n\nerror ('mine');\nend\n");
%! assert (told (), {' (slopeIn.m, line 3)'});

% SPDX-License-Identifier: GPL-3.0-only
