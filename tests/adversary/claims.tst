% A case waits for runs that another one, suspended, is about to make on the same
% store: it says for whom, and takes over after the time that the user set.

%!test
%! raw = standInCase (tempname ());
%! raw.Input.store = tempname ();
%! raw.Input.waitHours = 13 / 3600;
%! Case = newCase (raw);
%! jobs = newJobs (Case, [1, 2], [], 1, 'plan');
%! [pid, mark] = startSleep (60);
%! kill (pid, 19);
%! tidy = onCleanup (@() kill (pid, 9));
%! place = fullfile (Case.store, 'optim', 'First');
%! mkdir (place);
%! claim = fullfile (place, ['claim-', jobs(1).key]);
%! writeAtomic (claim, sprintf ("%s %d %s\n/home/b/sand\n", gethostname (), ...
%!                              pid, mark));
%! text = evalc (['records = runJobs (jobs, Case, ', ...
%!                'newProgress (''plan'', @disp));']);
%! assert ({records.status}, {'ok', 'ok'});
%! word = sprintf ('1 run(s) are about to be made by the case /home/b/sand (%s', ...
%!                 sprintf ('process %d', pid));
%! assert (~isempty (strfind (text, word)), text);
%! assert (isfile (claim));
%! assert (! isfile (fullfile (Case.folder, 'decalioc.waits')));
%! % the run is there now: nobody waits
%! [~, isReused] = runJobs (jobs, Case, @(s) []);
%! assert (isReused, [true, true]);

% SPDX-License-Identifier: GPL-3.0-only
