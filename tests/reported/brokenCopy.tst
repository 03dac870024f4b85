% A copy of a store that broke off left a run folder with its end mark alone: it was read
% as a run without a result, for ever. And --afresh moved a link to another disk aside
% without a word: the new runs filled the disk of the case.

%!shared folder
%! folder = reportedCase ('stale');
%!test
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, out);
%! run = @(varargin) fullfile (folder, 'optim', 'M', '0003', varargin{:});
%! for name = {'out', 'params.csv', 'pid', 'record.json', 'runscript', 'stdout.txt'}
%!   unlink (run (name{1}));
%! end
%! [~, out] = startCommand (folder, 'status');
%! assert (! isempty (strfind (out, '1 broken off, to be made again')), out);
%! [status, out] = startCommand (folder, 'run');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, '; 0 without a result')), out);
%! assert (! isfile (run ('record.json')));
%!test
%! far = tempname ();
%! rename (fullfile (folder, 'optim'), far);
%! symlink (far, fullfile (folder, 'optim'));
%! [status, out] = startCommand (folder, 'run --afresh');
%! assert (status == 0, out);
%! assert (! isempty (strfind (out, ['optim was a link to ', far])), out);
%! assert (isempty (readlink (fullfile (folder, 'optim'))));
%! assert (isfile (fullfile (far, 'M', '0001', 'record.json')));

% SPDX-License-Identifier: GPL-3.0-only
