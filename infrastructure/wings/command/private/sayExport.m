% SAYEXPORT  Writes the runs of a case as a table, or its values for a program.
%
% CALL: STATUS = sayExport (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts: a file; '--for' PROGRAM of materialLines, or 'card' (a
%           JSON and a page: materialCard), with that '--with' FOLDER: a further case
%           of the material, or 'store': those on the store with the same first remark
%           in measured.csv
%   STATUS  0
%
% A table of runs cannot be runs.csv of the case itself: the next start would take
% it in.
%
% Errors: DEcalioc:sayExport:exists, :missingFile (no calibration);
% DEcalioc:materialLines:unknownName

function status = sayExport (root, folder, args)
  [options, words] = commandOptions (args, struct ('for', 'one', 'with', 'many'));
  program = options.('for');
  [Case, note] = caseToRead (root, folder);
  printf ('%s', note);
  [~, ~] = mkdir (fullfile (folder, 'results'));
  if isempty (program)
    sayRuns (Case, fileOf (words, Case, 'runs.csv'));
  else
    sayMaterial (Case, program, words, options.with);
  end
  sayChanged (Case);
  status = 0;
end

function file = fileOf (words, Case, name)
  file = fullfile (Case.folder, 'results', name);
  if ~isempty (words)
    file = words{1};
  end
end

function sayRuns (Case, file)
  if strcmp (make_absolute_filename (file), fullfile (Case.folder, 'runs.csv'))
    error ('DEcalioc:sayExport:exists', ...
           ['the table cannot be %s: the next start would take it in, and ' ...
            'the runs are in the store already. Take another name.'], file);
  end
  n = exportRuns (file, Case, gatherRuns (Case, true));
  printf ('%s  %s\n', countText (n, 'run'), file);
  if n == 0
    printf (['        no finished run counts for the input as it is; a table that is ', ...
             'there stays as it is\n']);
  end
end

function sayMaterial (Case, program, words, others)
  if Case.isCost
    calibration = readJsonFile (fullfile (Case.folder, 'results', 'best.json'));
  else
    stored = storedResult (Case);
    calibration = stored.calibration;
    if ~isempty (calibration) && ~isempty (stored.changed)
      word = sentence ('case.earlier.word', struct ('parts', {stored.changed}));
      calibration.reason = [word, '. ', calibration.reason];
    end
  end
  if isempty (calibration)
    error ('DEcalioc:sayExport:missingFile', ...
           ['there are no values yet: %s is missing, damaged, or of an earlier version. ' ...
            'Calibrate first: decalioc run %s'], ...
           fullfile (Case.folder, 'results', 'calibration.json'), Case.folder);
  end
  isCard = strcmp (program, 'card');
  name = ['material-', program, '.txt'];
  if isCard
    name = 'material.json';
  end
  [text, page] = materialText (Case, calibration, program, others);
  file = fileOf (words, Case, name);
  if isCard
    place = regexprep (file, '(\.json)?$', '.html', 'once');
    writeAtomic (place, page);
    printf ('page    %s\n', place);
  end
  writeAtomic (file, text);
  if ~isCard
    printf ('%s', text);
  end
  printf ('values  %s\n', file);
end

%!test
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! [status, text] = startCommand (raw.folder, 'export --for lammps');
%! assert (status == 1 && ~isempty (strfind (text, 'there are no values yet')), text);
%! [status, text] = startCommand (raw.folder, 'export --for');
%! assert (status == 1, text);
%!test
%! % a card of two cases: one that is named, and those of the store with one remark
%! raw = standInCase (tempname ());
%! other = standInCase (tempname ());
%! store = sprintf ('Input.store = ''%s'';', raw.folder);
%! places = {raw.folder, other.folder};
%! json = ['{"params":{"a":%g,"b":3},"interval90":{"a":[3.5,4.5],"b":null},', ...
%!         '"converged":true,"reason":"all met","date":"2026-01-01","version":"1",', ...
%!         '"targets":[{"model":"First","name":"x","unit":"","target":7,"sd":0.1,', ...
%!         '"result":7.1,"resultSd":0.2,"role":"calibrate","state":"met"}],', ...
%!         '"sensitivity":{"a":[0.9],"b":[0.05]}}'];
%! for k = 1:2
%!   writeLoadInput (places{k}, store);
%!   [~, ~] = mkdir (fullfile (places{k}, 'results'));
%!   writeAtomic (fullfile (places{k}, 'results', 'calibration.json'), ...
%!                sprintf (json, 3 + k / 10));
%!   raws = {raw, other}{k};
%!   raws.Input.store = raw.folder;
%!   evaluateDEM ([1, 2 + k], newCase (raws));
%! end
%! card = @() jsondecode (fileread (fullfile (raw.folder, 'results', ...
%!                                            'material.json')));
%! for words = {['--with ', other.folder], '--with store'}
%!   [status, text] = startCommand (raw.folder, ['export --for card ', words{1}]);
%!   assert (status == 0, text);
%!   made = card ();
%!   assert (numel (made.cases), 2);
%!   a = made.values(strcmp ({made.values.name}, 'a'));
%!   assert ({a.value, a.by, a.agrees, numel(a.others)}, {3.1, {'x'}, true, 1});
%! end
%! % of an earlier input the file says so itself
%! result = jsondecode (sprintf (json, 3));
%! result.input = resultInput (newCase (raws));
%! [result.input.digest.targets, result.runs] = deal ('other', 1);
%! place = @(k) fullfile (places{k}, 'results', 'calibration.json');
%! writeAtomic (place (2), jsonencode (result));
%! [status, text] = startCommand (other.folder, 'export --for lammps');
%! assert (status == 0, text);
%! text = fileread (fullfile (other.folder, 'results', 'material-lammps.txt'));
%! assert (~isempty (regexp (text, '^#[^\n]* Result of an earlier input \(targets')), text);
%! page = fileread (fullfile (raw.folder, 'results', 'material.html'));
%! assert (~isempty (strfind (page, 'calibrated in')), page);
%! [status, text] = startCommand (raw.folder, 'export --for card --with /tmp');
%! assert (status == 1 && ~isempty (strfind (text, 'holds no results')), text);

% SPDX-License-Identifier: GPL-3.0-only
