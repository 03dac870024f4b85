% What ends a file of tests (endTests.sh): processor time of all that it has started,
% not the clock of a busy machine; far behind that, the clock.

%!function [note, isGone] = limited (work, seconds)
%!  % WORK is done by a child of a process that only waits for it
%!  folder = emptyFolder ();
%!  tool = fullfile (fileparts (which ('startProgram')), 'endTests.sh');
%!  file = fullfile (folder, 'note');
%!  line = sprintf (['TMPDIR=%s setsid bash -c ''%s & wait; :'' > /dev/null 2>&1 & p=$!; ', ...
%!                   'bash %s %d $p %s %s 2> /dev/null; ', ...
%!                   'for i in $(seq 100); do kill -0 $p 2> /dev/null || exit 1; ', ...
%!                   'sleep 0.1; done'], ...
%!                  folder, work, shellQuote (tool), seconds, folder, file);
%!  isGone = system (line) ~= 0;
%!  note = '';
%!  if isfile (file)
%!    note = strtrim (fileread (file));
%!  end
%!endfunction

%!test
%! [note, isGone] = limited ('while :; do :; done', 2);
%! assert (note, 'ended at its limit of 2 s of processor');
%! assert (isGone);
%!test
%! [note, isGone] = limited ('sleep 60', 2);
%! assert (note, 'ended at its limit of 8 s of the clock');
%! assert (isGone);
%!test
%! % what ends by itself is not ended
%! [note, isGone] = limited ('sleep 1', 2);
%! assert (note, '');
%! assert (isGone);

% SPDX-License-Identifier: GPL-3.0-only
