% KEEPRECORD  Writes the record of a run, and keeps what it said before.
%
% CALL: KEPT = keepRecord (RECORD)
%
%   RECORD  see newRecord
%   KEPT    what record.json of its folder holds now: what the run answered to
%           other questions in its field readings (see readingOf; the last 50);
%           whose run it is and what it was made for, as its job says; and the
%           status 'forgotten', if decalioc forget has set it meanwhile
%
% The record that is there is read at once before the new one is written, as
% another case may have asked the same run since.

function kept = keepRecord (record)
  file = [record.folder, '/record.json'];
  old = readSane (file);
  job = readSane ([record.folder, '/job.json']);
  kept = record;
  for name = {'stage', 'planRow', 'origin', 'owner'}
    made = givenField (old, name{1}, givenField (job, name{1}, []));
    if ~isempty (made)
      kept.(name{1}) = made;
    end
  end
  if isfield (old, 'status')
    kept = withReadings (kept, old);
  end
  writeRecord (file, kept);
end

function kept = withReadings (kept, old)
  fields = {'funs', 'status', 'message', 'cause', 'results'};
  pick = @(r) cell2struct (cellfun (@(n) givenField (r, n, ''), fields, ...
                                    'UniformOutput', false), fields, 2);
  isForgotten = strcmp (old.status, 'forgotten');
  if isForgotten
    [old.status, old.message] = beforeForgotten (old.message);
  end
  others = givenField (old, 'readings', struct ('funs', {}));
  readings = [pick(old); arrayfun(pick, others(:))];
  stays = ismember ({readings.status}, {'ok', 'invalid'}) & ...
          ~ismember ({readings.funs}, {'', kept.funs});
  readings = readings(stays);
  if ~isempty (readings)
    kept.readings = readings(1:min (end, 50));
  end
  if isForgotten && ~strcmp (kept.status, 'forgotten')
    kept.message = sprintf ('was %s. %s', kept.status, kept.message);
    kept.status = 'forgotten';
  end
end

%!function r = put (r, funs, z, status)
%!  [r.funs, r.results, r.status] = deal (funs, z, status);
%!  keepRecord (r);
%!  r = readRecord (fullfile (r.folder, 'record.json'));
%!endfunction
%!test
%! folder = emptyFolder ();
%! job = standInJob ();
%! [job.origin, job.owner] = deal ('/a', repmat ('b', 1, 32));
%! writeRecord (fullfile (folder, 'job.json'), job);
%! new = newRecord (setfield (job, 'origin', '/b'), folder);
%! r = put (new, 'f', [1, 2], 'ok');
%! assert ({r.origin, isfield(r, 'readings')}, {'/a', false});
%! % another question, a third one, the first one anew
%! put (new, 'g', 3, 'invalid');
%! r = put (new, 'h', 4, 'ok');
%! assert ({r.results, {r.readings.results}}, {4, {3, [1, 2]}});
%! r = put (new, 'f', [5, 6], 'ok');
%! assert ({r.results, {r.readings.funs}}, {[5, 6], {'h', 'g'}});
%! % one that was forgotten meanwhile stays so
%! r.message = 'was ok. ';
%! r.status = 'forgotten';
%! writeRecord (fullfile (folder, 'record.json'), r);
%! r = put (new, 'g', 7, 'ok');
%! assert ({r.status, r.message, r.results}, {'forgotten', 'was ok. ', 7});
%! assert ({r.readings.status}, {'ok', 'ok'});
%! % what was no record is no answer, whatever its checksum says; a field more
%! file = fullfile (folder, 'record.json');
%! for bad = {'x', struct('status', 'ok')}
%!   body = [jsonencode(rmfield (r, 'readings'))(1:end - 1), ...
%!           ',"readings":', jsonencode(bad{1}), '}'];
%!   writeAtomic (file, sprintf ('{"sha256":"%s","record":%s}\n', ...
%!                               hash ('sha256', body), body));
%!   assert (isfield (put (new, 'g', 7, 'ok'), 'readings'), false);
%! end
%! r = put (new, 'h', 4, 'ok');
%! r.readings.more = 1;
%! writeRecord (file, r);
%! assert (put (new, 'f', 5, 'ok').readings(2).results, 7);

% SPDX-License-Identifier: GPL-3.0-only
