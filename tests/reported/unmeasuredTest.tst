% A new state that was measured on one of two tests. Once the other one was run as
% often in its diagnosis, and took two thirds of the time.

%!function folder = twoTests ()
%!  addpath (fileparts (which ('startToolbox')));
%!  raw = standInCase (tempname ());
%!  folder = raw.folder;
%!  writeLoadInput (folder, ['Input.maxNewRuns = 400; Input.numOfSam = 12; ', ...
%!                           'optim.targetVal = {}; optim.tolRes = 0.02;']);
%!  noise = ' + 0.05 * sin(1000 * (a + 2 * b + 3 * e) + substr(v["runSeed"], 5))';
%!  for model = {'First', 'Second'}
%!    run = fullfile (folder, 'DEMmodels', model{1}, 'runscript');
%!    text = strrep (fileread (run), 'a * b + e', 'a * b + 3 * e');
%!    text = strrep (text, 'a + b + e', ['a + b + e', noise]);
%!    writeAtomic (run, strrep (text, 'a - b + e', ['a - b - 2 * e', noise]));
%!  end
%!  writeAtomic (fullfile (folder, 'loadEffects.m'), ...
%!    ["function effects = loadEffects ()\n", ...
%!     "effects = struct ('name', 'own', 'variables', {{'e'}}, ...\n", ...
%!     "                  'neutral', 0, 'limits', [0; 5]);\nend\n"]);
%!  put (folder, "condition,model,name,value,sd\n");
%!  put (folder, "reference,First,r1,11,0.1\nreference,First,r2,24,0.1\n");
%!  put (folder, "reference,Second,r3,5,0.1\n");
%!  put (folder, "one,First,r1,12.5,0.1\none,First,r2,28.6,0.1\n");
%!  for model = {'First', 'Second'}
%!    names = {"r1,,,,,\nr2,,,,,\n", "r3,,,,,\n"};
%!    writeAtomic (fullfile (folder, 'DEMmodels', model{1}, 'results.csv'), ...
%!                 ["name,kind,unit,series,at,text\n", ...
%!                  names{1 + strcmp(model{1}, 'Second')}]);
%!  end
%!endfunction
%!function put (folder, lines)
%!  file = fullfile (folder, 'measured.csv');
%!  writeAtomic (file, [checkReadText(file), lines]);
%!endfunction
%!function n = runsOf (folder)
%!  n = [numel(listRunFolders (folder, 'First')), numel(listRunFolders (folder, 'Second'))];
%!endfunction
%!function out = diagnosed (folder)
%!  [status, out] = startCommand (folder, 'diagnose');
%!  assert (status == 0, out);
%!endfunction

%!test
%! folder = twoTests ();
%! [~, out] = startCommand (folder, 'check');
%! assert (! isempty (strfind (out, 'are run with First: ')), out);
%! out = diagnosed (folder);
%! n = runsOf (folder);
%! assert (n(1) > 12);
%! assert (n(2), 0);
%! assert (! isempty (strfind (out, 'Second was not measured in the new state')), out);
%! gap = readJsonFile (fullfile (folder, 'gap', 'gap.json'));
%! assert (gap.demRuns.failed, 0);
%! assert (gap.reference.notMeasured.model, 'Second');
%! % nothing is run twice
%! diagnosed (folder);
%! assert (runsOf (folder), n);
%! % measured at last: now it is run, too
%! put (folder, "one,Second,r3,2.1,0.1\n");
%! diagnosed (folder);
%! assert (runsOf (folder)(2) > 12);

% SPDX-License-Identifier: GPL-3.0-only
