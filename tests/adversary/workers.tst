% Workers of parcellfun are killed, one after the other: the start goes on.

%!function n = recordsOf (folder)
%!  n = numel (glob (fullfile (folder, 'optim', '*', '*', 'record.json')));
%!endfunction

%!test
%! nKills = 3;
%! if strcmp (getenv ('DECALIOC_SOAK'), '1')
%!   nKills = 60;
%! end
%! folder = tempname ();
%! standInCase (folder);
%! writeLoadInput (folder, sprintf ('Input.numOfSam = %d;', 2 * nKills + 4));
%! for name = {'First', 'Second'}
%!   file = fullfile (folder, 'DEMmodels', name{1}, 'runscript');
%!   writeAtomic (file, ["sleep 0.2\n", fileread(file)]);
%! end
%! start = sprintf ('echo $$ > pid; exec octave-cli --norc %s', ...
%!                  shellQuote (which ('faultProgram')));
%! system (sprintf (['cd %s && { sh -c %s > log 2>&1 < /dev/null; ', ...
%!                   'echo $? > end; } > /dev/null 2>&1 &'], folder, ...
%!                  shellQuote (start)));
%! rand ('twister', 1);
%! killed = 0;
%! last = 0;
%! while ~isfile (fullfile (folder, 'end'))
%!   pause (0.3 * rand ());
%!   % one at a time: four in a row without a step between end the start
%!   if killed < nKills && recordsOf (folder) > last
%!     last = recordsOf (folder);
%!     killed += ~system (sprintf (['w=$(pgrep -P $(cat %s/pid) -f rfeval ', ...
%!                                  '| shuf -n 1) && kill -KILL $w'], folder));
%!   end
%! end
%! said = fileread (fullfile (folder, 'log'));
%! assert (strcmp (strtrim (fileread (fullfile (folder, 'end'))), '0'), said);
%! assert (killed, nKills);
%! % each set has its results, and no finished run was made twice
%! Z = csvread (fullfile (folder, 'answer.csv'));
%! assert (rows (Z) == 2 * nKills + 4 && ~any (isnan (Z(:))), said);
%! keys = {};
%! for file = glob (fullfile (folder, 'optim', '*', '*', 'record.json'))'
%!   record = readRecord (file{1});
%!   keys = [keys, {record.key}(strcmp (record.status, 'ok'))];
%! end
%! assert (numel (unique (keys)), numel (keys));
%! assert (numel (keys), 2 * rows (Z));

% SPDX-License-Identifier: GPL-3.0-only
