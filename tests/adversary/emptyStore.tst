% The first case of an empty store, looked at and started again.

%!test
%! raw = standInCase (tempname ());
%! raw.Input.store = tempname ();
%! writeLoadInput (raw.folder, sprintf ("Input.store = '%s';", ...
%!                                      raw.Input.store));
%! % what its first start has done when it is killed after the first run
%! raw.optim.targetVal = {[7, 12], 1};
%! Case = newCase (raw);
%! libraryRuns (Case, newProblem (Case));
%! evaluateDEM ([1, 2], Case);
%! [status, out] = startCommand (raw.folder, 'status');
%! assert (status == 0 && isempty (strfind (out, 'error')), out);
%! [status, out] = startCommand (raw.folder, 'check');
%! assert (status == 0 && ~isempty (strfind (out, ': 0 runs of 0')), out);

% SPDX-License-Identifier: GPL-3.0-only
