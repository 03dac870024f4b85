% Issue 47, 11: limits, numOfSam or seed were changed, and all finished runs of
% the case were silently unused.

%!function edited (folder, varargin)
%!  file = fullfile (folder, 'loadInput.m');
%!  text = fileread (file);
%!  for k = 1:2:numel (varargin)
%!    assert (! isempty (strfind (text, varargin{k})));
%!    text = strrep (text, varargin{k:k + 1});
%!  end
%!  writeAtomic (file, text);
%!endfunction
%!test
%! folder = reportedCase ('stale');
%! startCommand (folder, 'run');
%! n = numel (listRunFolders (folder, 'M'));
%! assert (n >= 9);
%! % the same input: its own way again, to the last run
%! [~, out] = startCommand (folder, 'run');
%! assert (isempty (strfind (out, 'own runs')));
%! assert (numel (listRunFolders (folder, 'M')), n);
%! edited (folder, '[0.0 0.0; 1.0 2.0]', '[0.2 0.4; 1.0 2.0]', ...
%!         'numOfSam = 8', 'numOfSam = 10');
%! [~, out] = startCommand (folder, 'check');
%! said = regexp (out, ['own runs  the input has changed: (\d+) earlier runs ', ...
%!                      'are reused(?:, (\d+) too far outside the limits)?'], ...
%!                'tokens', 'once');
%! counts = str2double (said);
%! assert (sum (counts(~isnan (counts))) == n, out);
%! assert (counts(1) >= 5);
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, out);
%! assert (numel (listRunFolders (folder, 'M')) < n + 10);
%! % and again: the same runs, none of them made twice
%! n = numel (listRunFolders (folder, 'M'));
%! startCommand (folder, 'run');
%! assert (numel (listRunFolders (folder, 'M')), n);

% SPDX-License-Identifier: GPL-3.0-only
