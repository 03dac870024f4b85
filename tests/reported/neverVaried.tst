% Tables of runs that never varied a parameter, or only in a fixed ratio to another:
% it got a value, a share and an interval, which were the prior of the surrogate.

%!function [c, out] = with (column)
%!  folder = reportedCase ('neverVaried');
%!  file = fullfile (folder, 'runs.csv');
%!  table = strsplit (strtrim (fileread (file)), "\n");
%!  for k = 2:numel (table)
%!    words = strsplit (table{k}, ',');
%!    words{4} = column (str2double (words{3}), k);
%!    table{k} = strjoin (words, ',');
%!  end
%!  writeAtomic (file, [strjoin(table, "\n"), "\n"]);
%!  [status, out] = startCommand (folder, 'run');
%!  assert (any (status == [0, 2]), '%s', out);
%!  assert (isempty (strfind (out, 'warning: ')), '%s', out);
%!  c = readJsonFile (fullfile (folder, 'results', 'calibration.json'));
%!  c.head = fileread (fullfile (folder, 'results', 'calibrated.head'));
%!endfunction

%!test
%! [c, out] = with (@(mu, k) '0.1');
%! assert (fieldnames (c.params), {'mu'});
%! assert (fieldnames (c.interval90), {'mu'});
%! assert (! isempty (strfind (out, 'WARNING: rolling was never varied')), out);
%! assert (! isempty (regexp (out, 'not for: .*rolling was never varied')), out);
%! assert (! isempty (strfind (c.head, 'variable rolling equal 0.1')), c.head);

%!test
%! % in a fixed ratio, with the digits of a table
%! [c, out] = with (@(mu, k) sprintf ('%.4f', 0.25 * mu));
%! assert (fieldnames (c.params), {'mu'});
%! assert (! isempty (regexp (out, 'not for: .*rolling was varied only together with mu')));
%! rolling = str2double (regexp (c.head, 'rolling equal (\S+)', 'tokens'){1}{1});
%! assert (rolling, 0.25 * c.params.mu, 0.01);

%!test
%! % varied by itself: as ever
%! c = with (@(mu, k) sprintf ('%.2f', mod (k * 0.17, 0.4)));
%! assert (fieldnames (c.params), {'mu'; 'rolling'});
%! assert (isempty (c.neverVaried));

% SPDX-License-Identifier: GPL-3.0-only
