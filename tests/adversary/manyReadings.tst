% Materials that were measured at other places share the runs of a store.

%!function Case = material (store, part)
%!  % points of the curve of measured.csv: the lines in PART
%!  folder = tempname ();
%!  measuredCase (folder);
%!  keepLines (folder, part);
%!  file = fullfile (folder, 'loadInput.m');
%!  text = strrep (fileread (file), 'Input.numOfSam = 12', ...
%!                 sprintf ('Input.store = ''%s''; Input.numOfSam = 5', store));
%!  writeAtomic (file, strrep (text, 'maxFunEvals = 20', 'maxFunEvals = 2'));
%!  Case = caseIn (folder);
%!endfunction
%!function keepLines (folder, part)
%!  file = fullfile (folder, 'measured.csv');
%!  if ~isfile ([file, '.all'])
%!    copyfile (file, [file, '.all']);
%!  end
%!  lines = strsplit (fileread ([file, '.all']), "\n");
%!  writeAtomic (file, [strjoin(lines([1:6, part]), "\n"), "\n"]);
%!endfunction
%!function Case = caseIn (folder)
%!  here = cd (folder);
%!  back = onCleanup (@() cd (here));
%!  clear loadInput
%!  Case = loadCase (fileparts (fileparts (which ('startToolbox'))), folder);
%!  clear loadInput
%!endfunction
%!function n = readingCount (Case)
%!  folder = fullfile (Case.store, 'optim', 'Bin');
%!  names = listRunFolders (Case.store, 'Bin');
%!  n = cellfun (@(f) stat (fullfile (folder, f, 'record.json')).mtime, names)';
%!endfunction

%!shared A, B, P
%! P = [1, 2; 0.8, 1.5; 1.2, 2.5; 0.6, 1.2; 1.5, 2.9];
%! A = material (tempname (), 10:12);
%! evaluateDEM (P, A);
%! B = material (A.store, 10:14);

%!test
%! % more places: the commands work, the runs of A are samples of B
%! for words = {'status', 'check'}
%!   [status, out] = startCommand (B.folder, words{1});
%!   assert (status == 0 && isempty (strfind (out, 'error:')), out);
%! end
%! data = libraryRuns (B, newProblem (B));
%! assert (size (data.Z), [5, 8]);
%! assert (all (isfinite (data.Z)(:)));
%! % neither start reads the runs of the other one anew, nor again
%! before = readingCount (A);
%! [Z, records] = evaluateDEM (P, A);
%! assert (size (Z), [5, 6]);
%! libraryRuns (B, newProblem (B));
%! assert (libraryRuns (B, newProblem (B)).Z, data.Z);
%! assert (readingCount (A), before);
%! % each its own places; those that both measured are the same
%! assert (sortrows (Z), sortrows (data.Z(:, 1:6)));
%! assert ([runsOfCase(A).isCurrent], true (1, 5));

%!test
%! % measured.csv changed since: nothing of the old places is shown
%! folder = A.folder;
%! bestOf = @(Case) bestSet (Case, runsOfCase (Case), []);
%! assert (numel (bestOf (A).results), 6);
%! for part = {10:14, 40:42, 10}
%!   keepLines (folder, part{1});
%!   Case = caseIn (folder);
%!   if ~isequal (part{1}, 10:14)        % those B has asked
%!     assert (isempty (bestOf (Case)));
%!     assert (all (strcmp ({runsOfCase(Case).state}, 'ended')));
%!   end
%!   reportPage (Case);
%! end
%! [status, out] = startCommand (folder, 'status');
%! assert (status == 0, out);
%! assert (~isempty (strfind (out, '5 to be read at the next start')), out);
%! % read anew, and back: nothing is lost
%! assert (size (evaluateDEM (P, Case)), [5, 4]);
%! assert (numel (bestOf (Case).results), 4);
%! keepLines (folder, 10:12);
%! assert (numel (bestOf (caseIn (folder)).results), 6);

% SPDX-License-Identifier: GPL-3.0-only
