% Flow of a diagnosis of several conditions: all are judged by the same runs.

%!function gaps = gapsOf (folder, conditions)
%!  for c = conditions
%!    gaps.(c{1}) = readJsonFile (fullfile (folder, 'gap', c{1}, 'gap.json'));
%!  end
%!  gaps.first = readJsonFile (fullfile (folder, 'gap', 'gap.json'));
%!endfunction

%!test
%! % runs that a later condition asks for count in those before it: a second
%! % start, which finds all runs, comes to the same numbers in each, and makes none
%! addpath (fileparts (which ('startToolbox')));
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder, ['Input.maxNewRuns = 400; ', ...
%!                              'Input.numOfSam = 12; ', ...
%!                              'optim.targetVal = {}; optim.tolRes = 0.02;']);
%! noise = ' + 0.05 * sin(1000 * (a + 2 * b + 3 * e) + substr(v["runSeed"], 5))';
%! for model = {'First', 'Second'}
%!   run = fullfile (raw.folder, 'DEMmodels', model{1}, 'runscript');
%!   text = strrep (fileread (run), 'a * b + e', 'a * b + 3 * e');
%!   text = strrep (text, 'a + b + e', ['a + b + e', noise]);
%!   writeAtomic (run, strrep (text, 'a - b + e', ['a - b - 2 * e', noise]));
%! end
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'First', 'results.csv'), ...
%!              "name,kind,unit,series,at,text\nr1,,,,,\nr2,,,,,\n");
%! writeAtomic (fullfile (raw.folder, 'DEMmodels', 'Second', 'results.csv'), ...
%!              "name,kind,unit,series,at,text\nr3,,,,,\n");
%! writeAtomic (fullfile (raw.folder, 'loadEffects.m'), ...
%!   ["function effects = loadEffects ()\n", ...
%!    "effects = struct ('name', 'own', 'variables', {{'e'}}, ...\n", ...
%!    "                  'neutral', 0, 'limits', [0; 5]);\nend\n"]);
%! writeAtomic (fullfile (raw.folder, 'measured.csv'), ...
%!   ["condition,model,name,value,sd\n", ...
%!    "reference,First,r1,11,0.1\nreference,First,r2,24,0.1\n", ...
%!    "reference,Second,r3,5,0.1\n", ...
%!    "same,First,r1,11.02,0.1\nsame,First,r2,24.05,0.1\nsame,Second,r3,4.97,0.1\n", ...
%!    "one,First,r1,12.5,0.1\none,First,r2,28.6,0.1\none,Second,r3,2.1,0.1\n", ...
%!    "two,First,r1,11.1,0.1\ntwo,First,r2,24.2,0.1\ntwo,Second,r3,4.6,0.1\n"]);
%! words = [shellQuote(fullfile (raw.root, 'bin', 'decalioc')), ' diagnose ', ...
%!          raw.folder, ' 2>&1'];
%! [status, out] = system (words);
%! assert (status == 0, out);
%! first = gapsOf (raw.folder, {'same', 'one', 'two'});
%! % the first that has changed leads; each has its own file
%! assert (first.first.reference.condition, 'one');
%! assert (first.one, first.first);
%! assert (first.same.cause.kind, 'none');
%! assert (! isempty (strfind (out, 'same: ')), out);
%! n = numel (listRunFolders (raw.folder, 'First'));
%! [status, out] = system (words);
%! assert (status == 0, out);
%! second = gapsOf (raw.folder, {'two'});
%! assert (numel (listRunFolders (raw.folder, 'First')), n);
%! for name = {'first', 'two'}
%!   [a, b] = deal (first.(name{1}), second.(name{1}));
%!   assert (struct2cell (a.which.posterior), struct2cell (b.which.posterior));
%!   assert (a.which.verdict, b.which.verdict);
%! end

% SPDX-License-Identifier: GPL-3.0-only
