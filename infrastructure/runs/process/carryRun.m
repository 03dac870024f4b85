% CARRYRUN  Takes one run a step on: what workers of parcellfun do.
%
% CALL: ANSWER = carryRun (PLACE, CASE, OWNER)
%
%   PLACE   folder (text) with orders: files *.order that hold k (number of the
%           run), job (see newJobs), folder (see takeRunFolder) and hasEnded
%           (the folder has an end mark)
%   CASE    see newCase; root, folder, store, models, modelVars, names,
%           effectVars and hashes (see hashModels) are read
%   OWNER   process number of the Octave that carries out the plan
%   ANSWER  [] where there was no order, else a struct: k, record (see
%           newRecord; [] of a run that is under way now), fault ([] or message
%           and identifier of an error)
%
% A run that has not ended is prepared and started, which takes some hundredths
% of a second: its guard waits for it, and looks after OWNER, not after this
% worker. One that has ended is evaluated and gets its record.

function answer = carryRun (place, Case, owner)
  leaveNoCore ();
  answer = [];
  [order, file] = takeOrder (place);
  if isempty (order)
    return
  end
  tidy = onCleanup (@() unlink (file));    % there for as long as it is at work
  answer = struct ('k', order.k, 'record', [], 'fault', []);
  try
    if order.hasEnded
      [record, where] = judgeRun (order.job, order.folder, Case);
      answer.record = evaluateRun (record, where);
    else
      prepareRun (order.job, Case, order.folder);
      startRun (order.folder, Case.root, owner);
    end
  catch err
    answer.fault = struct ('message', err.message, ...
                           'identifier', err.identifier);
  end
end

% Whoever renames the file, to <number of the run>.<process>, has the order.
function [order, mine] = takeOrder (place)
  order = [];
  mine = '';
  names = readdir (place);
  for name = names(~cellfun (@isempty, strfind (names, '.order')))'
    mine = fullfile (place, strrep (name{1}, 'order', int2str (getpid ())));
    if rename (fullfile (place, name{1}), mine) == 0
      order = load (mine);
      return
    end
  end
end

%!test
%! Case = readyCase ();
%! place = emptyFolder ();
%! assert (isempty (carryRun (place, Case, getpid ())));
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! folder = fullfile (Case.store, 'optim', 'First', '0001');
%! makeRunFolder (folder);
%! order = struct ('k', 7, 'job', job, 'folder', folder, 'hasEnded', false);
%! file = fullfile (place, '1.order');
%! % once to start it, once to evaluate it
%! saveWhole ('-binary', file, order);
%! answer = carryRun (place, Case, getpid ());
%! assert ({answer.k, answer.record, answer.fault}, {7, [], []});
%! assert (numel (readdir (place)), 2);
%! waitUntil (@() ~isempty (readEndMark (folder)));
%! order.hasEnded = true;
%! saveWhole ('-binary', file, order);
%! answer = carryRun (place, Case, getpid ());
%! assert (answer.record.results, [3, 2], 1e-12);
%! % a fault is told
%! order.hasEnded = false;
%! Case.models(1).folder = '/nowhere';
%! saveWhole ('-binary', file, order);
%! answer = carryRun (place, Case, getpid ());
%! assert (answer.fault.identifier, 'DEcalioc:copyModel:cannotWrite');

% SPDX-License-Identifier: GPL-3.0-only
