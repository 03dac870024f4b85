% A candidate of which every run fails was called excluded, or the cause of
% nothing: "no listed cause explains it".

%!test
%! folder = reportedCase ('failedEffect');
%! [status, out] = startCommand (folder, 'diagnose');
%! assert (status == 0, out);
%! said = 'moist could not be tested: its 4 runs failed (exit status 1).';
%! assert (~isempty (strfind (out, said)), out);
%! assert (isempty (strfind (out, 'no listed cause')), out);
%! gap = readJsonFile (fullfile (folder, 'gap', 'gap.json'));
%! assert (isempty (gap.which.cannotSee));
%! assert ({gap.which.untested.name, gap.which.untested.runs, ...
%!          gap.which.untested.why}, {'moist', 4, 'exit status 1'});
%! assert ({gap.verdict.cause.code, gap.verdict.cause.todo.code}, ...
%!         {'untested', 'mendEffect'});
%! page = fileread (fullfile (folder, 'results', 'report.html'));
%! assert (~isempty (strfind (page, said)));

% SPDX-License-Identifier: GPL-3.0-only
