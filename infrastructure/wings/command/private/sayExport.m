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
end

function sayMaterial (Case, program, words, others)
  if costAlone (Case)
    calibration = readJsonFile (fullfile (Case.folder, 'results', 'best.json'));
  else
    calibration = storedResult (Case).calibration;
  end
  if isempty (calibration)
    error ('DEcalioc:sayExport:missingFile', ...
           ['there are no values yet: %s is missing. Calibrate first: decalioc ' ...
            'run %s'], fullfile (Case.folder, 'results', 'calibration.json'), ...
           Case.folder);
  end
  list = materialValues (Case, calibration);
  if strcmp (program, 'card')
    card = materialCard (list, withOthers (Case, calibration, others));
    name = 'material.json';
    text = [jsonencode(card), "\n"];
    page = regexprep (fileOf (words, Case, name), '(\.json)?$', '.html', 'once');
    writeAtomic (page, cardPage (Case.root, card));
    printf ('page    %s\n', page);
  else
    lines = materialLines (program, list);
    own = "# Your script has names of its own: set these values in it.\n";
    text = [remarks(calibration, list), lines, own(1:end * isempty (lines))];
    name = ['material-', program, '.txt'];
  end
  file = fileOf (words, Case, name);
  writeAtomic (file, text);
  if ~strcmp (program, 'card')
    printf ('%s', text);
  end
  printf ('values  %s\n', file);
end

% What the values are worth, in front of them.
function text = remarks (c, list)
  lines = {resultTitle(c, c.date)};
  for one = list(strcmp ({list.from}, 'calibrated'))
    known = 'no interval';
    if all (isfinite (one.interval))
      known = sprintf ('90 %%: %.4g to %.4g', one.interval);
    end
    lines{end + 1} = sprintf ('%s %.6g (%s)', one.name, one.value, known);
  end
  lines = strcat ({'# '}, lines);
  text = strjoin ([lines, {''}], "\n");
end

% Of other cases their files are read, none of their programs is called: who shares a
% store need not be trusted.
function results = withOthers (Case, calibration, others)
  own = canonicalize_file_name (Case.folder);
  results = resultOf (Case.folder, calibration);
  isAll = strcmp (others, 'store');
  places = cellfun (@canonicalize_file_name, others(~isAll), 'UniformOutput', false);
  if any (isAll)
    [origins, marks] = casesOf (Case);
    same = cellfun (@(m) isequal (m(1:min (end, 1)), ...
                                  results.remarks(1:min (end, 1))), marks);
    places = [places, origins(same)];
  end
  for place = setdiff (places(cellfun (@ischar, places)), own)
    c = readJsonFile (fullfile (place{1}, 'results', 'calibration.json'));
    if isstruct (givenField (c, 'params', []))
      results(end + 1) = resultOf (place{1}, c);
    elseif any (strcmp (place{1}, others))
      error ('DEcalioc:sayExport:missingFile', ...
             '%s holds no results/calibration.json. Calibrate it first.', place{1});
    end
  end
end

function r = resultOf (folder, calibration)
  [~, base, ending] = fileparts (folder);
  r = struct ('name', [base, ending], 'remarks', {measuredRemarks(folder)}, ...
              'calibration', calibration);
end

function [places, remarks] = casesOf (Case)
  names = cell (1, 0);
  for model = Case.models
    kinds = readLibrary (runPlace (Case, model.name));
    names = [names, {kinds.origin}];
  end
  places = cell (1, 0);
  for name = unique (names)
    place = canonicalize_file_name (name{1});
    if ischar (place) && isfolder (place)
      places{end + 1} = place;
    end
  end
  places = unique (places);
  remarks = cellfun (@measuredRemarks, places, 'UniformOutput', false);
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
%! page = fileread (fullfile (raw.folder, 'results', 'material.html'));
%! assert (~isempty (strfind (page, 'calibrated in')), page);
%! [status, text] = startCommand (raw.folder, 'export --for card --with /tmp');
%! assert (status == 1 && ~isempty (strfind (text, 'holds no results')), text);
