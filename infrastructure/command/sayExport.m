% SAYEXPORT  Writes the runs of a case as a table, or its values for a program.
%
% CALL: STATUS = sayExport (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  case folder (text)
%   ARGS    cell of texts: a file; '--for' PROGRAM of materialLines, or 'card' (JSON:
%           values, where they are from, what they were measured against)
%   STATUS  0
%
% A table of runs cannot be runs.csv of the case itself: the next start would take
% it in.
%
% Errors: DEcalioc:sayExport:exists, :missingFile (no calibration);
% DEcalioc:materialLines:unknownName

function status = sayExport (root, folder, args)
  [options, words] = commandOptions (args, struct ('for', 'one'));
  program = options.('for');
  [Case, note] = caseToRead (root, folder);
  printf ('%s', note);
  [~, ~] = mkdir (fullfile (folder, 'results'));
  if isempty (program)
    sayRuns (Case, fileOf (words, Case, 'runs.csv'));
  else
    sayMaterial (Case, program, words);
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
  printf ('%d runs  %s\n', n, file);
end

function sayMaterial (Case, program, words)
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
    text = [jsonencode(cardOf (calibration, list)), "\n"];
    name = 'material.json';
  else
    sign = '#';
    if strcmp (program, 'mercury')
      sign = '//';
    end
    text = [remarks(calibration, list, sign), materialLines(program, list)];
    name = ['material-', program, '.txt'];
  end
  file = fileOf (words, Case, name);
  writeAtomic (file, text);
  printf ('%svalues  %s\n', text, file);
end

% What the values are worth, in front of them.
function text = remarks (c, list, sign)
  lines = {resultTitle(c, c.date)};
  for one = list(strcmp ({list.from}, 'calibrated'))
    known = 'no interval';
    if all (isfinite (one.interval))
      known = sprintf ('90 %%: %.4g to %.4g', one.interval);
    end
    lines{end + 1} = sprintf ('%s %.6g (%s)', one.name, one.value, known);
  end
  lines = strcat (sign, {' '}, lines);
  text = strjoin ([lines, {''}], "\n");
end

function card = cardOf (c, list)
  fields = {'model', 'name', 'unit', 'target', 'sd', 'result', 'resultSd', 'role', 'state'};
  tests = arrayfun (@(k) mergeFields (struct (), jsonAt (c, {'targets', k}), fields), ...
                    1:numel (c.targets), 'UniformOutput', false);
  card = struct ('converged', c.converged, 'reason', c.reason, 'date', c.date, ...
                 'version', c.version, 'values', {num2cell(list)}, 'tests', {tests});
end

%!test
%! raw = standInCase (tempname ());
%! writeLoadInput (raw.folder);
%! [status, text] = startCommand (raw.folder, 'export --for lammps');
%! assert (status == 1 && ~isempty (strfind (text, 'there are no values yet')), text);
%! [status, text] = startCommand (raw.folder, 'export --for');
%! assert (status == 1, text);
