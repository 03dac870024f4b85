% Cases on one store are told apart by their id, wherever they stand.

%!function Case = at (folder, store)
%!  % a case that is mounted at FOLDER, as in a container
%!  raw = standInCase (tempname ());
%!  raw.Input.store = store;
%!  caseId (raw.folder, true);
%!  rename (raw.folder, folder);
%!  raw.folder = folder;
%!  Case = newCase (raw);
%!endfunction

%!test
%! % two cases, both at one path; then each moved to a place of its own
%! store = tempname ();
%! place = tempname ();
%! A = at (place, store);
%! evaluateDEM ([1, 2; 3, 4], A);
%! A.folder = tempname ();
%! rename (place, A.folder);
%! A.models(1).folder = strrep (A.models(1).folder, place, A.folder);
%! A.models(2).folder = strrep (A.models(2).folder, place, A.folder);
%! B = at (place, store);
%! evaluateDEM ([5, 6], B);
%! names = @(Case) regexprep ({runsOfCase(Case).folder}, '^.*/', '');
%! assert (names (A), {'0001', '0002', '0001', '0002'});
%! assert (names (B), {'0003', '0003'});
%! assert (rows (gatherRuns (A, true).X), 2);
%! assert (rows (gatherRuns (B, true).X), 1);
%! assert (rows (gatherRuns (B).X), 3);
%! % listed apart; a path that both had names none of them
%! [~, out] = startCommand (tempdir (), ['runs ', store]);
%! for id = {caseId(A.folder), caseId(B.folder)}
%!   line = sprintf ('of %s (case %.8s): ', place, id{1});
%!   assert (~isempty (strfind (out, line)), out);
%! end
%! forget = @(name) startCommand (tempdir (), ...
%!                                ['forget ', store, ' First --case ', name]);
%! [status, out] = forget (A.folder);
%! assert (status == 0 && strncmp (out, '2 runs of First', 15), out);
%! [~, out] = forget ([caseId(A.folder)(1:8), ' --back']);
%! assert (~isempty (strfind (out, '2 runs of First are in use')), out);
%! gone = B.folder;
%! B.folder = tempname ();
%! rename (gone, B.folder);
%! [status, out] = forget (place);
%! assert (status == 1 && ~isempty (strfind (out, 'must name one case')), out);
%! assert ({runsOfCase(A).state}, repmat ({'ok'}, 1, 4));

%!test
%! % a copy is a case of its own; runs of before, which name a path alone
%! A = at (tempname (), tempname ());
%! evaluateDEM ([1, 2], A);
%! copy = tempname ();
%! system (['cp -a ', A.folder, ' ', copy]);
%! B = setfield (A, 'folder', copy);
%! assert (numel (runsOfCase (B)), 0);
%! evaluateDEM ([3, 4], B);
%! assert ([numel(runsOfCase (A)), numel(runsOfCase (B))], [2, 2]);
%! file = fullfile (A.store, 'optim', 'First', '0001', 'record.json');
%! writeRecord (file, rmfield (readRecord (file), 'owner'));
%! assert ([numel(runsOfCase (A)), numel(runsOfCase (B))], [2, 2]);

% SPDX-License-Identifier: GPL-3.0-only
