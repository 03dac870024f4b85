% Flow of the gap diagnosis: which runs of the store count.

%!test
%! % runs of the store count, with their effects, also after the list changes
%! addpath (fileparts (which ('startToolbox')));
%! raw = standInCase (tempname (), fileparts (fileparts (which ('newCase'))));
%! raw.effects = struct ('name', 'own', 'variables', {{'e'}}, ...
%!                       'neutral', 0, 'limits', [0; 5]);
%! Case = newCase (raw);
%! Z = evaluateDEM ([2, 3; 2, 3; 4, 5], Case, [1; 2; 1], 'gap', ...
%!                  @(state) [], [0; 0; 2]);
%! [data, count] = gatherRuns (Case);
%! assert (count.store, 6);
%! [~, order] = sortrows ([data.X, data.E, data.replicate]);
%! assert (data.X(order, :), [2, 3; 2, 3; 4, 5]);
%! assert (data.E(order), [0; 0; 2]);
%! assert (data.Z(order, :), Z);
%! % a list with one effect more, before it (the runs so far are of models
%! % that do not know it, and do not count)
%! longer = raw;
%! longer.effects = [struct('name', 'new', 'variables', {{'b2'}}, ...
%!                          'neutral', 1, 'limits', [0; 5]), raw.effects];
%! for model = {'First', 'Second'}
%!   head = fullfile (raw.folder, 'DEMmodels', model{1}, 'data.head');
%!   writeAtomic (head, [fileread(head), "variable b2 equal 1\n"]);
%! end
%! Case = newCase (longer);
%! evaluateDEM ([2, 3; 4, 5], Case, 1, 'gap', @(state) [], [1, 0; 1, 2]);
%! [data, count] = gatherRuns (newCase (raw));
%! assert (data.E, [0; 2]);
%! [data, count] = gatherRuns (Case);
%! assert (count.store, 4);
%! assert (sortrows (data.E), [1, 0; 1, 2]);
%! longer.effects = longer.effects([2, 1]);
%! [data, count] = gatherRuns (newCase (longer));
%! assert (count.store, 4);
%! assert (sortrows (data.E), [0, 1; 2, 1]);
%! % getResults was corrected: stored runs are evaluated again; so are those
%! % whose record was lost
%! funs = fullfile (raw.folder, 'DEMmodels', 'Second', 'OctaveFuns', ...
%!                  'getResults.m');
%! text = fileread (funs);
%! writeAtomic (funs, strrep (text, '(load (file)'')', '(10 * load (file)'')'));
%! unlink (fullfile (raw.folder, 'optim', 'Second', ...
%!                   listRunFolders (raw.folder, 'Second'){end}, ...
%!                   'record.json'));
%! later = gatherRuns (newCase (longer));
%! assert (later.Z(:, 3), 10 * data.Z(:, 3), 1e-9);
%! assert (later.Z(:, 1:2), data.Z(:, 1:2));
%! % a list without it
%! raw.effects = [];
%! [data, count] = gatherRuns (newCase (raw));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');
%! assert (count.store, 2);
%! assert (data.X, [2, 3]);
