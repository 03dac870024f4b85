% Cases that share a store: the second one starts from the runs of the first.

%!function c = calibrationOf (folder)
%!  c = jsondecode (fileread (fullfile (folder, 'results', ...
%!                                      'calibration.json')));
%!endfunction
%!function folder = material (store, targets, extra)
%!  folder = tempname ();
%!  standInCase (folder);
%!  writeLoadInput (folder, sprintf ("Input.store = '%s';\n%s\n%s", store, ...
%!                                   targets, extra));
%!endfunction

%!shared store, first, second, box
%! store = tempname ();
%! box = 'paramLims = [2, 1; 12, 8];';

%!test
%! % the second material: other targets, other limits, the same bench
%! first = material (store, '', '');
%! assert (startProgram (first), 0);
%! second = material (store, 'optim.targetVal = {[11, 30], -1};', box);
%! [status, out] = startCommand (second, 'check');
%! assert (status, 0);
%! assert (~isempty (regexp (out, 'library +\S+: \d+ runs of 1 case ')));
%! assert (~isfolder (fullfile (second, 'results')));
%! [status, out] = startProgram (second);
%! assert (status, 0);
%! assert (~isempty (strfind (out, 'gave what it predicts')));
%! [a, b] = deal (calibrationOf (first), calibrationOf (second));
%! assert ([b.params.a, b.params.b], [5, 6], 0.1);
%! sets = @(c) c.demRuns.plan + c.demRuns.infill + c.demRuns.verify;
%! assert (sets (b) <= sets (a) / 2);
%! [status, out] = startCommand (second, 'status');
%! assert (~isempty (regexp (out, 'library \d+ runs of 1 case ')));
%! page = fileread (fullfile (second, 'results', 'report.html'));
%! assert (~isempty (strfind (page, 'runs of 1 case in')));

%!test
%! % started again it repeats no run, though others have been added since
%! before = calibrationOf (second);
%! third = material (store, 'optim.targetVal = {[9, 18], 3};', '');
%! assert (startProgram (third), 0);
%! n = numel (listRunFolders (store, 'First'));
%! assert (startProgram (second), 0);
%! assert (numel (listRunFolders (store, 'First')), n);
%! assert (calibrationOf (second).params, before.params);

%!test
%! % a bench that was changed behind its model folder: passed over, and said
%! bin = tempname ();
%! mkdir (bin);
%! writeAtomic (fullfile (bin, 'awk'), ["#!/bin/sh\n", ...
%!   "/usr/bin/awk \"$@\" | ", ...
%!   "/usr/bin/awk '{ printf \"%.17g\\n\", 1.3 * $1 }'\n"]);
%! system (['chmod +x ', fullfile(bin, 'awk')]);
%! path = getenv ('PATH');
%! restore = onCleanup (@() setenv ('PATH', path));
%! changed = material (store, 'optim.targetVal = {[11.7, 23.4], 3.9};', '');
%! setenv ('PATH', [bin, ':', path]);
%! [status, out] = startProgram (changed);
%! assert (status, 0);
%! assert (~isempty (strfind (out, 'stored runs of other cases are not used')));
%! c = calibrationOf (changed);
%! assert (any (~cellfun (@isempty, strfind (c.warnings, 'are not used'))));
%! assert ([c.params.a, c.params.b], [6, 3], 0.1);

%!test
%! % a place for all cases of a user; runs that are taken out of use
%! restore = onCleanup (@() setenv ('DECALIOC_STORE', ''));
%! setenv ('DECALIOC_STORE', store);
%! own = tempname ();
%! standInCase (own);
%! writeLoadInput (own);
%! used = @(out) str2double (regexp (out, ': (\d+) runs of', 'tokens'){1}{1});
%! [~, out] = startCommand (own, 'check');
%! n = used (out);
%! assert (n > 40);
%! [status, out] = startCommand (own, 'runs');
%! assert (status, 0);
%! assert (~isempty (strfind (out, ['of ', second])));
%! startCommand (own, sprintf ('forget %s First --case %s', store, first));
%! [~, out] = startCommand (own, 'check');
%! assert (used (out) < n);

% SPDX-License-Identifier: GPL-3.0-only
