% SAYWATCH  Follows a calibration at the terminal until it ends.
%
% CALL: STATUS = sayWatch (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts: '--seconds' N, time between two looks (default 5)
%   STATUS  that of sayStatus at the last look
%
% Shows what decalioc status says, and the probability that all targets are met,
% anew in the same place. Where nobody works in the case, or the output is no
% terminal (DECALIOC_SCREEN of bin/decalioc is not 'yes'), it says so once. Ends
% when the case does; Ctrl-C is that of the shell. Writes nothing.
%
% Errors: DEcalioc:sayWatch:badValue  of --seconds; those of sayStatus

function status = sayWatch (root, folder, args)
  options = commandOptions (args, struct ('seconds', 'one'));
  seconds = secondsOf (options.seconds);
  isScreen = strcmp (getenv ('DECALIOC_SCREEN'), 'yes');
  while true
    isOpen = isScreen && isWorkedIn (folder);  % first: the last look is whole
    [text, status] = look (root, folder);
    if isScreen
      text = ["\033[H\033[2J", text];
    end
    printf ('%s', text);
    if ~isOpen
      return
    end
    printf (['\n%s, every %g s. Ctrl-C ends this view, not the ' ...
             'calibration.\n'], strftime ('%H:%M:%S', localtime (time ())), ...
            seconds);
    fflush (stdout ());
    pause (seconds);
  end
end

function seconds = secondsOf (text)
  seconds = 5;
  if ~isempty (text)
    seconds = str2double (text);
  end
  if ~(seconds >= 1 && seconds <= 1e5)
    error ('DEcalioc:sayWatch:badValue', ...
           ['--seconds must be a number from 1, got %s. Give the seconds ' ...
            'between two looks.'], text);
  end
end

% As one text, so that the screen is not empty while the runs are read.
function [text, status] = look (root, folder)
  status = 0;
  text = evalc ('status = sayStatus (root, folder, {});');
  found = readJsonFile (fullfile (folder, 'results', 'progress.json'));
  chance = jsonAt (found, {'probability'});
  if isnumeric (chance) && isscalar (chance)
    text = sprintf ('%schance  %.0f %% that all targets are met, at %s\n', ...
                    text, 100 * chance, jsonAt (found, {'date'}));
  end
end

% By its lock, or by a job of decalioc submit that has not begun yet.
function yes = isWorkedIn (folder)
  [~, state] = submittedJob (folder);
  yes = any (strcmp (lockHolder (folder).state, {'alive', 'unknown'})) || ...
        any (strcmp (state, {'waiting', 'running'}));
end

%!test
%! % no terminal: once; nothing is worked at: once, on a screen too
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! mkdir (fullfile (raw.folder, 'results'));
%! writeAtomic (fullfile (raw.folder, 'results', 'progress.json'), ...
%!              '{"probability": 0.42, "date": "2026-01-02 03:04"}');
%! lock = lockCase (raw.folder);
%! [status, text] = startCommand (raw.folder, 'watch');
%! assert (status == 0, text);
%! assert (numel (strfind (text, 'state   running')) == 1, text);
%! assert (~isempty (strfind (text, 'chance  42 % that all')), text);
%! assert (isempty (strfind (text, "\033")));
%!test
%! % on a screen it ends with the case
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! [pid, mark] = startSleep (15);
%! writeAtomic (fullfile (raw.folder, 'decalioc.lock'), ...
%!              sprintf ('%s %d %s', gethostname (), pid, mark));
%! root = fileparts (fileparts (which ('startToolbox')));
%! call = [shellQuote(fullfile (root, 'bin', 'decalioc')), ...
%!         ' watch --seconds 1 ', shellQuote(raw.folder)];
%! [status, text] = system (['timeout 100 script -qec ', shellQuote(call), ...
%!                           ' /dev/null < /dev/null']);
%! assert (status, 0);
%! assert (~isempty (strfind (text, 'state   running')), text);
%! assert (~isempty (strfind (text, 'Ctrl-C ends')), text);
%! last = regexprep (text, '^.*\x1b', '');
%! assert (~isempty (strfind (last, 'Start with')), text);
%! assert (isempty (strfind (last, 'Ctrl-C ends')), text);
%!error id=DEcalioc:sayWatch:badValue sayWatch ('', '', {'--seconds=0'})

% SPDX-License-Identifier: GPL-3.0-only
