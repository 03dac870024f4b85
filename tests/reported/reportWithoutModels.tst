% Runs of a table alone, and no DEMmodels: the page of the result ended in an
% error of Octave. What only reads the case has to do without a model folder.

%!test
%! folder = reportedCase ('reportWithoutModels');
%! page = fullfile (folder, 'results', 'report.html');
%! [status, out] = startCommand (folder, 'run');
%! assert (any (status == [0, 2]) && isfile (page), '%s', out);
%! assert (isempty (strfind (out, 'could not be written')), '%s', out);
%! unlink (page);
%! [status, out] = startCommand (folder, 'report');
%! assert (status == 0 && isfile (page), '%s', out);
%! for command = {'status', 'export', 'cancel', 'check', 'check --try'}
%!   [status, out] = startCommand (folder, command{1});
%!   assert (status == 0 && isempty (strfind (out, 'called from')), ...
%!           '%s: %s', command{1}, out);
%! end
%! assert (isempty (strfind (out, 'failed')), out);

% SPDX-License-Identifier: GPL-3.0-only
