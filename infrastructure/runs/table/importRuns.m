% IMPORTRUNS  Takes runs that were made elsewhere from a table runs.csv.
%
% CALL: [DATA, IGNORED] = importRuns (FILE, CASE)
%
%   FILE     path; header model (optional where the case has one, besides those
%            in CASE.further), seed (optional), the design variables, the
%            effect variables (optional: neutral), the targets, in any order;
%            a field is empty where the column does not belong to the row's
%            model (a parameter: in all its rows), and empty or -, n/a, None ...
%            (isNoResult) without a result; an error of a spreadsheet (#DIV/0!),
%            failed or inf: a run without this result; a unit may stand behind a
%            name (aor [deg]); one row a run, or
%            several (see spreadRuns; readRunsTable for the accepted forms)
%   CASE     struct with names, effectVars, effects, targets, models, further
%            (optional)
%   DATA     struct X (n x d), E (n x v), Z (n x T, NaN = no result, NA = not
%            run, or a field left empty beside others), replicate (n x 1),
%            stage (n x 1 cell, 'import')
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
  [~, table] = readRunsTable (file, Case);
  header = table.names;
  column = findColumns (header, Case, file);
  model = modelNumbers (table, column.model, Case);
  ignored = checkColumns (header, Case, model, file);
  X = withoutOthers (numbers (table, column.names, Case.names), model);
  if any (isnan (X(:)))
    refuseBlank (X, model, table, Case);
  end
  given = column.effects > 0;
  E = NaN (rows (X), numel (given));
  E(:, given) = numbers (table, column.effects(given), Case.effectVars(given));
  neutral = repmat (neutralEffects (Case), rows (X), 1);
  E(isnan (E)) = neutral(isnan (E));
  targets = NaN (rows (X), numel (Case.targets));
  given = column.targets > 0;
  [values, isFailed] = numbers (table, column.targets(given), ...
                                {Case.targets(given).name});
  % a failed run, which filledUp does not take for one that was not made
  values(isFailed) = Inf;
  targets(:, given) = values;
  seed = NaN (rows (X), 1);
  if column.seed > 0
    seed = numbers (table, column.seed, {'seed'});
  end
  targets(model ~= [Case.targets.model]) = NaN;
  data = joinModels (toDigits ([X, E]), model, seed, targets, Case);
  % a seed says that a row is one run, in which a missing result is one
  if column.seed == 0
    data = filledUp (data, [Case.targets.model]);
  end
  data.Z(isinf (data.Z)) = NaN;
end

% Stages of a campaign that measure one target each: a row that lacks some of
% its model's results has not been run for them, and those of rows of one set
% are put side by side. A row without any result is a run that failed.
function data = filledUp (data, model)
  Z = data.Z;
  for k = unique (model)
    mine = Z(:, model == k);
    isPart = any (isfinite (mine), 2) & any (isnan (mine), 2);
    mine(isPart & isnan (mine)) = NA;
    Z(:, model == k) = mine;
  end
  if isequaln (isna (Z), isna (data.Z))
    return
  end
  [~, ~, set] = unique ([data.X, data.E], 'rows');
  for t = 1:columns (Z)
    [~, order] = sortrows ([set, ~isfinite(Z(:, t)) + isna(Z(:, t))]);
    [~, place] = sortrows ([set, (1:rows (Z))']);
    Z(place, t) = Z(order, t);
  end
  data.Z = Z;
  data = keepRows (data, ~all (isna (Z), 2));
end

% A parameter that a model does not have is empty in all its rows. Its results are
% the same at any value: each set gets another one, all over the range of the other
% models, so that its surrogates see that it changes nothing.
function X = withoutOthers (X, model)
  given = ~isnan (X);
  for k = unique (model)'
    for j = find (~any (given(model == k, :), 1) & any (given, 1))
      own = model == k;
      [~, ~, set] = unique (X(own, all (given(own, :), 1)), 'rows');
      ends = [min(X(given(:, j), j)), max(X(given(:, j), j))];
      step = sqrt ([2, 3, 7]);
      X(own, j) = ends(1) + diff (ends) * mod (set * step(mod (j, 3) + 1), 1);
    end
  end
end

function refuseBlank (X, model, table, Case)
  [row, j] = find (isnan (X), 1);
  cure = 'Fill it in, or take the line out.';
  if all (isnan (X(model == model(row), j)))
    cure = sprintf ('No row of %s has one, nor of another model. %s', ...
                    Case.models(model(row)).name, cure);
  end
  error ('DEcalioc:importRuns:badValue', ...
         ['importRuns: line %d of %s must give every design variable, got none for ' ...
          '%s. %s'], table.lines(row), table.file, Case.names{j}, cure);
end

function column = findColumns (header, Case, file)
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
end

% The columns of a model that has no rows here may be missing: a bench that
% joined the case later.
function ignored = checkColumns (header, Case, model, file)
  targets = {Case.targets.name};
  isHere = ismember ([Case.targets.model], model);
  needed = [{'model'}, Case.names, targets(isHere)];
  further = givenField (Case, 'further', {});
  if sum (~ismember ({Case.models.name}, further)) == 1
    needed(1) = [];
  end
  missing = needed(~ismember (needed, header));
  if ~isempty (missing)
    cure = sprintf ('One of another name: decalioc import --column THEIRS=%s.', missing{1});
    if numel (missing) == numel (needed) && any (isfinite (str2double (header)))
      cure = 'The first line must name the columns.';
    end
    error ('DEcalioc:importRuns:missingField', ...
           ['importRuns: %s must have the columns %s; missing: %s. Columns ' ...
            'found: %s. %s'], file, strjoin (needed, ', '), ...
           strjoin (missing, ', '), strjoin (header, ', '), cure);
  end
  aside = cellfun (@(f) givenField (Case, f, []), {'fixed', 'thinned'}, ...
                   'UniformOutput', false);
  aside = cellfun (@(s) {s(:).name}, aside(~cellfun (@isempty, aside)), ...
                   'UniformOutput', false);
  known = [{'model', 'seed'}, Case.names, Case.effectVars, targets, aside{:}];
  ignored = setdiff (header, known);
end

function model = modelNumbers (table, column, Case)
  names = {Case.models.name};
  if column == 0
    model = ones (rows (table.cells), 1);
    return
  end
  [~, model] = ismember (lower (table.cells(:, column)), lower (names));
  model = reshape (model, [], 1);
  if isscalar (names)
    model(cellfun (@isempty, table.cells(:, column))) = 1;
  end
  bad = find (model == 0, 1);
  if ~isempty (bad)
    error ('DEcalioc:importRuns:unknownName', ...
           'importRuns: model in line %d of %s must be one of %s, got ''%s''.', ...
           table.lines(bad), table.file, strjoin (names, ', '), ...
           table.cells{bad, column});
  end
end

function [values, isFailed] = numbers (table, column, names)
  texts = table.cells(:, column);
  values = reshape (str2double (texts), size (texts));
  blank = cellfun ('isempty', texts);
  [isNone, isFailed] = isNoResult (texts);
  wrong = isnan (values) & ~blank & ~isNone;
  % str2double takes a comma for a separator of thousands: 0,45 would be 45
  if any ([texts{:}] == ',')
    wrong = wrong | ~cellfun ('isempty', strfind (texts, ','));
  end
  [row, col] = find (wrong | imag (values) ~= 0, 1);
  values = real (values);
  isFailed = isFailed | isinf (values);
  values(isinf (values)) = NaN;
  if ~isempty (row)
    text = texts{row, col};
    error ('DEcalioc:importRuns:badValue', ...
           ['importRuns: %s in line %d of %s must be a number with a ' ...
            'decimal point, no complex one, got ''%s''.%s'], ...
           names{col}, table.lines(row), table.file, text, ...
           cureOf (text, names{col}));
  end
end

function cure = cureOf (text, name)
  cures = {[char([194, 177]), '|\+/?-'], ...
           sprintf([' Write the mean alone, the number of runs in a column n ' ...
                    'and their scatter in a column sd %s.'], name); ...
           '^\s*[<>~=]', ' Leave it empty where no number was found.'; ...
           '^[-+.\d]+(e[-+]?\d+)?\s*[^-+\s.,\d]', ...
           sprintf(' Put the unit into the header: %s [...].', name); ...
           '^[A-Za-z]', ' Leave the field empty, or take the line out.'};
  cure = '';
  for k = rows (cures):-1:1
    if ~isempty (regexp (text, cures{k, 1}, 'once', 'ignorecase'))
      cure = cures{k, 2};
    end
  end
end

%!function [data, ignored] = imported (text, isEffect)
%!  Case = readyCase ();
%!  if nargin > 1
%!    Case.effectVars = {'coh'};
%!    Case.effects = struct ('neutral', 5);
%!  end
%!  file = fullfile (Case.folder, 'runs.csv');
%!  writeAtomic (file, text);
%!  [data, ignored] = importRuns (file, Case);
%!endfunction
%!shared head
%! head = "model;a;b;First_1;First_2;Second_1\n";
%!assert (imported ([head, "First;0,5;2;3;4;\n"]).X, [0.5, 2])
%!test
%! data = imported ([head, "First;0,5;2;3;4;\n;;;;;\nFirst;0,5;2;3;5;\n;;;\n"]);
%! assert (data.replicate, [1; 2]);
%! assert (data.Z(:, 2), [4; 5]);
%!test
%! % other order, no effects, a comment column, an exact repeat
%! [data, ignored] = imported ( ...
%!   ["note,Second_1,a,b,First_1,First_2,model,seed\n", ...
%!    "x,30,1,2,,,Second,7\n", "x,30,1,2,,,Second,7\n", ...
%!    ",31,1,2,,,Second,8\n", "y,,1,2,5,6,First,9\n"], true);
%! assert (ignored, {'note'});
%! assert (data.X, [1, 2; 1, 2]);
%! assert (data.E, [5; 5]);
%! assert (isequaln (data.Z, [5, 6, 30; NaN, NaN, 31]));
%!test
%! % rows that lack a target, and one that failed
%! data = imported ([head, "First;1;2;5;;\nFirst;3;4;;6;\nFirst;1;2;;7;\n", ...
%!                   "First;1;2;8;;\nFirst;9;9;;;\n"]);
%! assert (data.X, [1, 2; 3, 4; 1, 2; 9, 9]);
%! assert (data.Z(:, 1:2), [5, 7; NA, 6; 8, NA; NaN, NaN]);
%!test
%! % a bench that joined the case later has no columns, and was not run
%! data = imported ("model,a,b,First_1,First_2\nFirst,1,2,5,6\n");
%! assert (data.Z(1:2), [5, 6]);
%! assert (isna (data.Z(3)));
%!test
%! % a test that joined the case leaves the table of its one model as it was
%! Case = setfield (readyCase (), 'further', {'Second'});
%! file = fullfile (Case.folder, 'runs.csv');
%! writeAtomic (file, "a,b,First_1,First_2\n1,2,5,6\n");
%! assert (importRuns (file, Case).Z(1:2), [5, 6]);
%!test
%! commas = strrep (head, ';', ',');
%! for bad = {"model,a,First_1,First_2,Second_1\n", 'missingField'; ...
%!            "model,a,First_1,First_2\nFirst,1,2,3\n", 'missingField'; ...
%!            "model,a,b,First_1\nFirst,1,2,3\n", 'missingField'; ...
%!            "a,b,First_1,First_2\n1,2,3,4\n", 'missingField'; ...
%!            [commas, "X,1,2,,,3\n"], 'unknownName'; ...
%!            [commas, "Second,a,2,,,3\n"], 'badValue'; ...
%!            [commas, "First,1.234,5,2,3+2i,4\n"], 'badValue'; ...
%!            [commas, "First,3i,2,3,4,\n"], 'badValue'; ...
%!            [commas, "First,\"0;5\",2,3,4,\n"], 'badValue'}'
%!   id = '';
%!   try
%!     imported (bad{1});
%!   catch err
%!     id = err.identifier;
%!   end
%!   assert (id, ['DEcalioc:importRuns:', bad{2}]);
%! end
%!error <One of another name: .* --column THEIRS=model> imported ("x,y,z\n1,2,3\n");
%!error <The first line must name the columns> imported ("0.1,2,3\n1,2,3\n");
%!error <line 3 .* got none for b. Fill it in>
%! imported ([head, "First;1;2;3;4;\nFirst;1;;2;3;\n"]);
%!error <line 2 .* got none for b. No row of First has one, nor of another>
%! imported ([head, "First;1;;3;4;\nSecond;1;;;;3\n"]);
%!test
%! % a model that does not have b: another value for each of its sets
%! data = imported ([head, "First;1;2;3;4;\nSecond;1;;;;3\nFirst;7;5;3;4;\n", ...
%!                   "Second;4;;;;5\nSecond;4;;;;6\n"]);
%! assert (data.X([1, 3], :), [1, 2; 7, 5]);
%! assert (data.X([2, 4], 1), [1; 4]);
%! assert (data.X(4, :), data.X(5, :));
%! assert (data.replicate, [1; 1; 1; 1; 2]);
%! assert (data.X(2, 2) ~= data.X(4, 2));
%! assert (data.X([2, 4], 2) > 2 & data.X([2, 4], 2) < 5);
%!test
%! % no result, in the words of spreadsheets and Python; units in the header
%! data = imported (["model,a [m],b,First_1 [deg],First_2,Second_1\n", ...
%!                   "First,1,2,5,-,\nFirst,1,3,n/a,None,\nFirst,1,4,5,6,\n"]);
%! assert (isequaln (data.Z(:, 1:2), [5, NA; NaN, NaN; 5, 6]));
%!test
%! % a failed result beside another one, not one that nobody looked for
%! data = imported (["model,a,b,First_1,First_2,Second_1\n", ...
%!                   "First,1,2,5,#DIV/0!,\nFirst,1,3,inf,6,\nFirst,1,4,5,#N/A,\n"]);
%! assert (isna (data.Z(:, 1:2)), logical ([0, 0; 0, 0; 0, 1]));
%! assert (isnan (data.Z(:, 1:2)), logical ([0, 1; 1, 0; 0, 1]));
%!test
%! % a thousand dot before a decimal comma says itself what it is
%! data = imported ([head, "First;1.234,5;2;3;4;\n"]);
%! assert (data.X(1), 1234.5);
%! commas = strrep (head, ';', ',');
%! assert (imported ([commas, "First,\"0,5\",2,3,4,\n"]).X(1), 0.5);

% SPDX-License-Identifier: GPL-3.0-only
