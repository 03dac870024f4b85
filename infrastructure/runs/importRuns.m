% IMPORTRUNS  Takes runs that were made elsewhere from a table runs.csv.
%
% CALL: [DATA, IGNORED] = importRuns (FILE, CASE)
%
%   FILE     path; header model, seed (optional), the design variables, the
%            effect variables (optional: neutral), the targets, in any order;
%            a field is empty where the column does not belong to the row's
%            model; one row a run (see readCsvTable for the accepted forms)
%   CASE     struct with names, effectVars, effects, targets, models
%   DATA     struct X (n x d), E (n x v), Z (n x T, NaN = no result, NA = not
%            run), replicate (n x 1), stage (n x 1 cell, 'import')
%   IGNORED  cellstr, columns that the case does not know
%
% Rows of different models with the same variables become one row of DATA; a
% model that has the same variables twice has been repeated with another seed
% (replicate 2, 3 ...). An exact repeat, same seed and results, counts once.
%
% Errors: DEcalioc:importRuns:missingField  a column that must be there
%         DEcalioc:importRuns:unknownName   a model that the case does not have
%         DEcalioc:importRuns:badValue      not a number, or twice a column

function [data, ignored] = importRuns (file, Case)
  [header, cells, lines] = readCsvTable (file);
  [column, ignored] = findColumns (header, Case, file);
  table = struct ('file', file, 'lines', lines, 'cells', {cells});
  model = modelNumbers (table, column.model, Case);
  X = numbers (table, column.names, Case.names);
  if any (isnan (X(:)))
    bad = find (any (isnan (X), 2), 1);
    error ('DEcalioc:importRuns:badValue', ...
           'importRuns: line %d of %s must give every design variable.', ...
           lines(bad), file);
  end
  E = repmat (neutralEffects (Case), rows (X), 1);
  given = column.effects > 0;
  values = numbers (table, column.effects(given), Case.effectVars(given));
  kept = E(:, given);
  values(isnan (values)) = kept(isnan (values));
  E(:, given) = values;
  targets = numbers (table, column.targets, {Case.targets.name});
  seed = NaN (rows (X), 1);
  if column.seed > 0
    seed = numbers (table, column.seed, {'seed'});
  end
  targets(model ~= [Case.targets.model]) = NaN;
  data = joinModels ([X, E], model, seed, targets, Case);
end

function [column, ignored] = findColumns (header, Case, file)
  [~, first] = unique (header, 'first');
  twice = setdiff (1:numel (header), first);
  if ~isempty (twice)
    error ('DEcalioc:importRuns:badValue', ...
           'importRuns: column %s of %s must stand there once.', ...
           header{twice(1)}, file);
  end
  [~, column.model] = ismember ('model', header);
  [~, column.seed] = ismember ('seed', header);
  [~, column.names] = ismember (Case.names, header);
  [~, column.effects] = ismember (Case.effectVars, header);
  [~, column.targets] = ismember ({Case.targets.name}, header);
  needed = [{'model'}, Case.names, {Case.targets.name}];
  if numel (Case.models) == 1
    needed = needed(2:end);
  end
  missing = needed(~ismember (needed, header));
  if ~isempty (missing)
    error ('DEcalioc:importRuns:missingField', ...
           ['importRuns: %s must have the columns %s; missing: %s. Columns ' ...
            'found: %s.'], file, strjoin (needed, ', '), ...
           strjoin (missing, ', '), strjoin (header, ', '));
  end
  known = [{'model', 'seed'}, Case.names, Case.effectVars, ...
           {Case.targets.name}];
  ignored = setdiff (header, known);
end

function model = modelNumbers (table, at, Case)
  names = {Case.models.name};
  if at == 0
    model = ones (rows (table.cells), 1);
    return
  end
  [found, model] = ismember (table.cells(:, at), names);
  model = reshape (model, [], 1);
  if ~all (found)
    bad = find (~found, 1);
    error ('DEcalioc:importRuns:unknownName', ...
           'importRuns: model in line %d of %s must be one of %s, got %s.', ...
           table.lines(bad), table.file, strjoin (names, ', '), ...
           table.cells{bad, at});
  end
end

function values = numbers (table, at, names)
  texts = table.cells(:, at);
  values = reshape (str2double (texts), size (texts));
  blank = cellfun ('isempty', texts);
  wrong = isnan (values) & ~blank & ~strcmpi (texts, 'nan') & ...
          ~strcmpi (texts, 'na');
  % str2double takes a comma for a separator of thousands: 0,45 would be 45
  if any ([texts{:}] == ',')
    wrong = wrong | ~cellfun ('isempty', strfind (texts, ','));
  end
  wrong = wrong | imag (values) ~= 0;
  values = real (values);
  values(isinf (values)) = NaN;
  if any (wrong(:))
    [row, col] = find (wrong, 1);
    error ('DEcalioc:importRuns:badValue', ...
           ['importRuns: %s in line %d of %s must be a number with a ' ...
            'decimal point, no complex one, got ''%s''.'], ...
           names{col}, table.lines(row), table.file, texts{row, col});
  end
end

%!function data = imported (text)
%!  Case = newCase (standInCase (tempname ()));
%!  file = fullfile (Case.folder, 'runs.csv');
%!  writeAtomic (file, ["model;a;b;First_1;First_2;Second_1\n", text]);
%!  data = importRuns (file, Case);
%!endfunction
%!assert (imported ("First;0,5;2;3;4;\n").X, [0.5, 2])
%!error id=DEcalioc:importRuns:badValue imported ("First;1.234,5;2;3;4;\n")
%!error id=DEcalioc:importRuns:badValue imported ("First;1+2i;2;3;4;\n")
%!error id=DEcalioc:importRuns:badValue imported ("First;3i;2;3;4;\n")
%!test
%! data = imported ("First;0,5;2;3;4;\n;;;;;\nFirst;0,5;2;3;5;\n;;;\n");
%! assert (data.replicate, [1; 2]);
%! assert (data.Z(:, 2), [4; 5]);
%!error id=DEcalioc:importRuns:badValue
%! Case = newCase (standInCase (tempname ()));
%! file = fullfile (Case.folder, 'runs.csv');
%! writeAtomic (file, ["model,a,b,First_1,First_2,Second_1\n", ...
%!                     "First,\"0,5\",2,3,4,\n"]);
%! importRuns (file, Case);
