% IMPORTHEADER  What the columns of a table of runs are.
%
% CALL: [NAMES, KINDS] = importHeader (HEADER, CASE, FILE)
%
%   HEADER  1 x c cell of names, as the table has them
%   CASE    see importRuns; with a field columns (k x 2 cell of texts: a column, what
%           it is to the case), as decalioc import --column has them
%   FILE    path of the table, for the error (text)
%   NAMES   1 x c cell: of "aor [deg]", "aor (deg)", "aor / deg", "aor in deg"
%           and "AOR" the name, where the case knows it, of "my_aor" my aor, and of
%           "friction 2-1" friction_1_2, of "force@0.0020" force@0.002: places are
%           numbers; of trial and scatter that of the result
%   KINDS   1 x c cell: model, seed, parameter, effect, result; trial (angle 1,
%           angle_2, angle.3: one of several runs of the row); runs (n) and
%           scatter (sd where there is one result, sd angle, angle_sd): see
%           spreadRuns; ignored
%
% Errors: DEcalioc:importRuns:badValue (another unit than that of the target, or than SI
% of a parameter, which would be another number; sd of several results)

function [names, kinds] = importHeader (header, Case, file)
  targets = {Case.targets.name};
  units = unitsOf (Case);
  known = [{'model', 'seed'}, Case.names, Case.effectVars, targets];
  kind = [{'model', 'seed'}, repmat({'parameter'}, size (Case.names)), ...
          repmat({'effect'}, size (Case.effectVars)), ...
          repmat({'result'}, size (targets)), {'ignored'}];
  header = renamed (header, givenField (Case, 'columns', cell (0, 2)));
  names = header;
  for k = find (~ismember (header, known))
    free = known(~ismember (known, names));
    [name, unit] = knownName (header{k}, free);
    if ~isempty (name)
      names{k} = name;
      checkUnit (name, unit, targets, units, file);
      checkParameter (name, unit, [Case.names, Case.effectVars], file);
    end
  end
  [~, at] = ismember (names, known);
  at(at == 0) = numel (kind);
  kinds = kind(at);
  for k = find (strcmp (kinds, 'ignored'))
    [names{k}, kinds{k}, unit] = severalRuns (names{k}, targets, file);
    checkUnit (names{k}, unit, targets, units, file);
  end
  % one column angle 1 is no list of trials, but a name
  for k = find (strcmp (kinds, 'trial'))
    if sum (strcmp (names, names{k}) & ismember (kinds, {'trial', 'result'})) == 1
      [names{k}, kinds{k}] = deal (header{k}, 'ignored');
    end
  end
  % the number of runs without their scatter, or this alone, says nothing
  if ~any (strcmp (kinds, 'runs'))
    kinds(strcmp (kinds, 'scatter')) = {'ignored'};
  end
end

% A unit behind the name stays.
function header = renamed (header, pairs)
  for pair = pairs'
    parts = regexp (header, '^(.*?)(\s*[[(][^])]*[])])?$', 'tokens', 'once');
    isIt = strcmp (header, pair{1}) | ...
           cellfun (@(p) strcmp (p{1}, pair{1}), parts);
    for k = find (isIt)
      header{k} = [pair{2}, parts{k}{2:end * ~strcmp(header{k}, pair{1})}];
    end
  end
end

% '' where TEXT is none of the known names; the unit behind it.
function [name, unit] = knownName (text, known)
  [name, unit] = deal ('');
  % a unit in brackets first: without its signs "a [%]" would be a
  forms = {'^(.*?)\s*[[(]([^])]*)[])]$', '^(.*?)()$', ...
           '^(.*?)\s*[/,;]\s*(\S+)$', '^(.*?)\s+in\s+(\S+)$'};
  for form = forms
    parts = regexp (regexprep (text, '\s+', ' '), form{1}, 'tokens', 'once');
    if isempty (parts)
      continue
    end
    k = find (strcmp (known, parts{1}));
    if isempty (k)
      k = find (strcmpi (known, parts{1}));
    end
    if isempty (k)                         % as --vary or a spreadsheet spells it
      k = find (strcmp (plain (known), plain (parts{1})));
    end
    if isempty (k)                         % as LIGGGHTS calls it
      own = regexprep (parts{1}, {'^coefficient', '^(cohesion)EnergyDensity'}, {'', '$1'});
      k = find (strcmp (plain (known), plain (own)));
    end
    if isempty (k)                         % the types of a pair in the other order
      turned = regexprep (parts{1}, '(\d+)\s*[-_ ]\s*(\d+)$', '$2-$1');
      k = find (strcmp (plain (known), plain (turned)));
    end
    if isempty (k) && any (parts{1} == '@')
      k = find (strcmpi (placed (known), placed (parts{1})));
    end
    if isscalar (k)
      [name, unit] = deal (known{k}, [parts{2:end}]);
      return
    end
  end
end

% Names with the place of a curve as measuredTarget writes it.
function names = placed (names)
  parts = regexp (names, '^(.*?)\s*@\s*([-+.,eE\d]+)$', 'tokens', 'once');
  if ischar (names)
    [names, parts] = deal ({names}, {parts});
  end
  for k = find (~cellfun (@isempty, parts))
    at = str2double (strrep (parts{k}{2}, ',', '.'));
    names{k} = sprintf ('%s@%.6g', parts{k}{1}, at);
  end
end

% Rolling friction 1-1 is rollingFriction_1_1, but 1-12 is not 11-2.
function texts = plain (texts)
  texts = lower (regexprep (texts, {'[^A-Za-z0-9\x80-\xff]+', '^_|_$'}, {'_', ''}));
  texts = regexprep (texts, '(?<=[a-z])_|_(?=[a-z])', '');
end

function [name, kind, unit] = severalRuns (text, targets, file)
  [name, kind, unit] = deal (text, 'ignored', '');
  if any (strcmp (text, {'n', 'N'}))
    kind = 'runs';
    return
  end
  parts = regexp (text, '^(.*?)\s*[[(]([^])\d]+)[])]$', 'tokens', 'once');
  if ~isempty (parts)
    [text, unit] = parts{:};
  end
  trial = regexp (text, '^(.*?)[ _#(]+\d+\)?$|^([^@]*)\.\d+$', 'tokens', 'once');
  scatter = regexp (text, ['^(?:sd|std|stdev)[ _.]*(.*)$|', ...
                           '^(.*?)[ _.]*(?:sd|std|stdev)$'], 'tokens', 'once');
  if ~isempty (trial) && ~isempty (knownName ([trial{:}], targets))
    [name, kind] = deal (knownName ([trial{:}], targets), 'trial');
  elseif ~isempty (scatter)
    of = strtrim ([scatter{:}, '']);
    known = knownName (of, targets);
    if isempty (of) && isscalar (targets)
      known = targets{1};
    elseif isempty (of)
      error ('DEcalioc:importRuns:badValue', ...
             ['importRuns: %s of %s must say of which result it is, got %s ' ...
              'for %s. Name the column sd %s.'], text, file, text, ...
             strjoin (targets, ', '), targets{1});
    end
    if ~isempty (known)
      [name, kind] = deal (known, 'scatter');
    end
  end
  if strcmp (kind, 'ignored')
    unit = '';
  end
end

% Of measured.csv, else of results.csv; '' where neither says one.
function units = unitsOf (Case)
  units = repmat ({''}, size (Case.targets));
  if isfield (Case, 'models') && isfield (Case.models, 'folder')
    units = {targetInfo(Case).unit};
  end
  if isfield (Case.targets, 'unit')
    isGiven = ~cellfun (@isempty, {Case.targets.unit});
    units(isGiven) = {Case.targets(isGiven).unit};
  end
end

function checkUnit (name, given, targets, units, file)
  t = find (strcmp (name, targets), 1);
  if isempty (given) || isempty (t) || isempty (units{t})
    return
  end
  if ~strcmp (units{t}, given) && ~isequal (unitFactor (given, units{t}), 1)
    error ('DEcalioc:importRuns:badValue', ...
           ['importRuns: %s of %s must be in %s, as results.csv of its ' ...
            'model says, got %s. Convert the column.'], name, file, units{t}, given);
  end
end

% Limits are in SI; a unit that nobody knows is the user's own.
function checkParameter (name, given, parameters, file)
  factor = unitFactor (given, 'SI');
  if strcmp (given, '%')
    factor = 0.01;
  end
  if any (strcmp (name, parameters)) && ~isempty (given) && ...
     ~isnan (factor) && abs (factor - 1) > 1e-9
    error ('DEcalioc:importRuns:badValue', ...
           ['importRuns: %s of %s must be in SI units, as its limits are, got %s. ' ...
            'Convert the column; where its limits are in %s, too, take the unit out ' ...
            'of its name.'], name, file, given, given);
  end
end

%!shared Case
%! Case = struct ('names', {{'a'}}, 'effectVars', {{'w'}});
%! Case.targets = struct ('name', {'x', 'm [kg]'}, 'unit', {'mm', ''});
%!test
%! [names, kinds] = importHeader ({'a [-]', 'x (mm)', 'm [kg]', 'w', 'note', ...
%!                                 'seed'}, Case, 'f');
%! assert (names, {'a', 'x', 'm [kg]', 'w', 'note', 'seed'});
%! assert (kinds, {'parameter', 'result', 'result', 'effect', 'ignored', 'seed'});
%!error <a of f must be in SI units, as its limits are, got rpm> ...
%! importHeader ({'a [rpm]', 'x'}, Case, 'f');
%!error <w of f must be in SI units> importHeader ({'w [mm]', 'x'}, Case, 'f');
%!error <a of f must be in SI units> importHeader ({'a [%]', 'x'}, Case, 'f');
%!assert (importHeader ({'a [rad/s]', 'x'}, Case, 'f'), {'a', 'x'})
%!test
%! for text = {'X', 'x / mm', 'x/mm', 'x in mm', "x\n[mm]"}
%!   assert (importHeader (text, Case, 'f'), {'x'});
%! end
%! [names, kinds] = importHeader ({'x 1', 'X_2 [mm]', 'n', 'sd x', 'm [kg] std'}, ...
%!                                Case, 'f');
%! assert (names([1, 2, 4, 5]), {'x', 'x', 'x', 'm [kg]'});
%! assert (kinds, {'trial', 'trial', 'runs', 'scatter', 'scatter'});
%! % a single one is a name; a point of a curve is no trial
%! [~, kinds] = importHeader ({'x 1', 'x@0.25'}, Case, 'f');
%! assert (kinds, {'ignored', 'ignored'});
%!test
%! % places of a curve are numbers, with a decimal comma, too
%! of = struct ('names', {{'a'}}, 'effectVars', {{}});
%! of.targets = struct ('name', {'p@0.002', 'p@0.01', 'p@5', 'p@0.333333'}, ...
%!                      'unit', 'kPa');
%! header = {'p@0.0020', 'P @ 1e-2 [kPa]', 'p@5,0', 'p@0.33333333333', 'p@7'};
%! [names, kinds] = importHeader (header, of, 'f');
%! assert (names, {'p@0.002', 'p@0.01', 'p@5', 'p@0.333333', 'p@7'});
%! assert (kinds, [repmat({'result'}, 1, 4), {'ignored'}]);
%!error <must be in mm, as results.csv of its model says, got m>
%! importHeader ({'x [m]'}, Case, 'f');
%!error <sd of f must say of which result> importHeader ({'n', 'sd'}, Case, 'f');
%!test
%! % targets of optim have the unit that results.csv has; blanks are underlines
%! root = fileparts (fileparts (which ('startToolbox')));
%! of = struct ('names', {{'a'}}, 'effectVars', {{}});
%! of.models = struct ('name', 'Heap', 'folder', fullfile (root, 'DEMmodels', 'Heap'));
%! of.targets = struct ('name', {'slope', 'my height'}, 'model', 1, 'index', {1, 2});
%! assert (importHeader ({'slope [deg]', 'My_height [m]'}, of, 'f'), ...
%!         {'slope', 'my height'});
%! fail ('importHeader ({''my height [mm]''}, of, ''f'')', 'must be in m, .* got mm');
%!test
%! % the spelling of --vary; names of the user's own
%! own = setfield (Case, 'names', {'friction_1_2', 'rollingFriction_1_1', 'mu_1_12'});
%! assert (importHeader ({'friction 1-2', 'Rolling friction 1-1', 'mu 1-12'}, own, 'f'), ...
%!         own.names);
%! assert (importHeader ({'friction(1,2)', 'coefficientRollingFriction 1-1'}, own, 'f'), ...
%!         own.names(1:2));
%! assert (importHeader ({'friction 2-1', 'mu 11-2'}, own, 'f'), ...
%!         {'friction_1_2', 'mu 11-2'});
%! own.columns = {'Reibung', 'friction 1-2'; 'Winkel', 'x'};
%! assert (importHeader ({'Reibung', 'Winkel (mm)'}, own, 'f'), {'friction_1_2', 'x'});

% SPDX-License-Identifier: GPL-3.0-only
