% CHECKMEASUREDTABLE  Checks the targets: of measured.csv, or else of optim.
%
% CALL: [P, FOUND] = checkMeasuredTable (RAW, MODELS, TAKEN)
%
%   RAW     see readInput: optim, what readConditions reads, and further, names
%           of the last of MODELS, whose targets are in tables of gap/next
%   MODELS  1 x M struct array, see checkFindModels
%   TAKEN   cell of names that a target may not have: variables
%   P       1 x n faults, see checkFault
%   FOUND   struct sizes (1 x M, targets of each model; [] where they make no
%           sense), groups, conditions and sessions, see groupMeasured; thinned,
%           see thinCurves
%
% The table stands in the place of the fields of optim that are given target by
% target. optim.tolRes may be one number: the tolerance where tol is empty.
% Targets of further models have the model's name in front: optim's are free.

function [p, found] = checkMeasuredTable (raw, models, taken)
  found = struct ('sizes', [], 'groups', [], 'conditions', {{}}, ...
                  'sessions', struct ('given', false, 'names', {{}}, ...
                                      'ratio', 0, 'df', 0), 'thinned', []);
  if isfile (fullfile (raw.folder, 'measured.csv'))
    [p, found] = checkTable (raw, models, taken, found);
    p = [p, checkTargets(raw.optim, models, taken, found.sizes)];
    return
  end
  isFurther = ismember ({models.name}, givenField (raw, 'further', {}));
  [p, found.sizes] = checkTargets (raw.optim, models(~isFurther), taken);
  if isequal (givenField (raw.optim, 'role', ''), {{'smallest'}}) && ...
     ~(isequal (givenField (raw.Input, 'maxNewRuns', Inf), 0) && ...
       isfile (fullfile (raw.folder, 'runs.csv')))
    p(end + 1) = checkFault ('costAlone', 'optim.role', ...
                             ['runs.csv with the history, and Input.maxNewRuns = ' ...
                              '0, beside ''smallest'''], 'runs to be made', ...
                             ['A cost alone is not searched on: give the results ' ...
                              'that it is made of.']);
  end
  if ~any (isFurther)
    return
  end
  [lines, q] = readConditions (raw, {models.name}, 'further');
  if ~isempty (q) || isempty (lines)
    p = [p, q];
    return
  end
  [lines, r] = checkUnits (lines, models);
  lines = contrastLines (lines, models);
  [found.groups, q] = groupMeasured (lines, {models.name});
  p = [p, r, q, checkTurns(lines)];
  names = strcat ({models([found.groups.model]).name}, '_', ...
                  {found.groups.name});
  [found.groups.name] = names{:};
  if ~isempty (found.sizes)
    count = @(k) sum ([found.groups.model] == k);
    found.sizes = [found.sizes, arrayfun(count, find (isFurther))];
  end
end

function [p, found] = checkTable (raw, models, taken, found)
  optim = raw.optim;
  p = checkTwice (optim);
  [lines, q] = readConditions (raw, {models.name});
  p = [p, q];
  if isempty (lines) || any ([lines.model] == 0) || ...
     (~isempty (q) && any (strcmp ({q.id}, ...
                                   'DEcalioc:checkCase:measuredCondition')))
    return
  end
  [lines, r] = checkUnits (lines, models);
  lines = contrastLines (lines, models);
  [groups, q, conditions, sessions] = ...
    groupMeasured (lines, {models.name}, givenField (raw, 'further', {}));
  p = [p, r, q, checkTurns(lines), checkTolerances(groups, lines, optim), ...
       checkNames(groups, [taken, {'model', 'seed'}]), ...
       checkMeasuredResults(groups, models)];
  if ~any (strcmp ({groups.role}, 'calibrate'))
    cures = {'Write what was measured into the column value.', ...
             'Write calibrate into the column role.'};
    p(end + 1) = checkFault ('noCalibrateTarget', 'measured.csv', ...
                             'at least one target to calibrate on', ...
                             'none that is measured and not held out', ...
                             cures{1 + any(isfinite ([groups.value]))});
  end
  [groups, found.thinned] = thinCurves (groups);
  sizes = arrayfun (@(k) sum ([groups.model] == k), 1:numel (models));
  for k = find (sizes == 0)
    p = [p, withoutLine(models(k).name, raw, p)];
  end
  [found.sizes, found.groups, found.conditions, found.sessions] = ...
    deal (sizes, groups, conditions, sessions);
end

% Of a further model whose table is at fault P says more.
function p = withoutLine (name, raw, p)
  table = 'measured.csv';
  cure = 'Add one, or take it out of Input.model.';
  if any (strcmp (name, givenField (raw, 'further', {})))
    table = fullfile ('gap', 'next', [name, '.csv']);
    cure = 'Write its name into the column model, or leave that out.';
  end
  isSaid = ~isempty (p) && ~strcmp (table, 'measured.csv') && ...
           any (strncmp ({p.message}, table, numel (table)));
  p = checkFault ();
  if ~isSaid
    p = checkFault ('measuredModel', table, ['a line of the model ', name], ...
                    'none', cure);
  end
end

function p = checkTwice (optim)
  p = checkFault ();
  isGiven = @(f) isfield (optim, f) && ~isKind ('nothing', optim.(f));
  fields = {'targetVal', 'targetName', 'targetStd', 'trials', 'role'};
  given = fields(cellfun (isGiven, fields));
  for name = given
    p(end + 1) = checkFault ('measuredTwice', ['optim.', name{1}], ...
                             'nothing, for measured.csv says it', ...
                             describeValue (optim.(name{1})), ...
                             'Take the field out, or measured.csv away.');
  end
  if isGiven ('tolRes') && ~(isKind ('number', optim.tolRes) && ...
                             optim.tolRes > 0 && optim.tolRes < 1)
    p(end + 1) = checkFault ('measuredTwice', 'optim.tolRes', ...
                             ['one number between 0 and 1, of all lines of measured.csv ' ...
                              'without tol'], describeValue (optim.tolRes), ...
                             'Write 0.02, for instance, or take the field out.');
  end
end

function p = checkTolerances (groups, lines, optim)
  p = checkFault ();
  default = NaN;
  if isfield (optim, 'tolRes') && isKind ('number', optim.tolRes)
    default = optim.tolRes;
  end
  isAsked = strcmp ({groups.role}, 'calibrate') & isnan ([groups.tol]);
  isZero = [groups.value] == 0;
  lines = lines([lines.saysTol]);          % at fault: that is said already
  place = @(rows) arrayfun (@(r) sprintf ('%s, line %d', r.file, r.line), rows, ...
                            'UniformOutput', false);
  open = @(is) setdiff (place (groups(isAsked & is)), place (lines), 'stable');
  [shares, zeros_] = deal (open (~isZero & isnan (default)), open (isZero));
  if ~isempty (shares)
    p = checkFault ('measuredTol', [shares{1}, ', tol'], ...
                    'a tolerance (0.02 or 2%)', ['nothing', andMore(shares)], ...
                    'Or set optim.tolRes = 0.02; for all that have none.');
  end
  if ~isempty (zeros_)
    p(end + 1) = checkFault ('measuredTol', [zeros_{1}, ', tol'], ...
                             'an absolute tolerance, as the value is 0', ...
                             ['nothing', andMore(zeros_)], ...
                             ['Write by how much it may be off, in its unit: ' ...
                              '0.1 abs. optim.tolRes is a share of the value, and ' ...
                              'a share of 0 is 0.']);
  end
end

function text = andMore (places)
  others = sprintf (', nor in %d more', numel (places) - 1);
  text = repmat (others, 1, ~isscalar (places));
end

function p = checkNames (groups, taken)
  p = checkFault ();
  names = {groups.name};
  [~, first] = unique (names, 'first');
  isTwice = ~ismember (1:numel (names), first);
  for k = find (isTwice | ismember (names, taken))
    where = sprintf ('%s, line %d, name', groups(k).file, groups(k).line);
    if isTwice(k)
      p(end + 1) = checkFault ('measuredName', where, ...
                               'a name for each target', ...
                               [describeValue(names{k}), ' twice'], ...
                               ['The names are columns of runs.csv: ' ...
                                'rename one of the two.']);
    else
      p(end + 1) = checkFault ('measuredName', where, ...
                               'a name that no variable has', ...
                               describeValue (names{k}), ...
                               'Rename the target: both are columns.');
    end
  end
end

%!function reasons = check (text, optim, model)
%!  folder = emptyFolder ();
%!  writeAtomic (fullfile (folder, 'measured.csv'), text);
%!  raw = struct ('folder', folder, 'Input', struct (), 'optim', optim);
%!  p = checkMeasuredTable (raw, model, {'densityP'});
%!  reasons = arrayfun (@(q) q.id(20:end), p, 'UniformOutput', false);
%!endfunction
%!shared model, tolRes, none
%! folder = emptyFolder ();
%! model = struct ('name', 'Toy', 'folder', folder, 'count', 1, ...
%!                 'fields', {{'a', 'w'}});
%! tolRes = struct ('tolRes', 0.1);
%! none = struct ();
%!test
%! for good = {"name,value,tol\na,1,0.1\n", none; ...
%!             "name,value\na,1\n", tolRes; ...
%!             "name,series,at,value\n,w,1,3\n,w,2,4\n", tolRes}'
%!   assert (isempty (check (good{:}, model)), good{1});
%! end
%! bad = {'measuredTol', "name,value\na,1\n", none; ...
%!        'measuredTol', "name,value\na,0\n", tolRes; ...
%!        'measuredTwice', "name,value\na,1\n", struct('tolRes', {{0.1}}); ...
%!        'measuredTwice', "name,value,tol\na,1,0.1\n", ...
%!        struct('targetVal', 3); ...
%!        'measuredResult', "name,value,tol\nb,1,0.1\n", none; ...
%!        'noCalibrateTarget', "name,value,tol\na,,0.1\n", none; ...
%!        'noCalibrateTarget', "name,value,tol,role\na,1,0.1,holdout\n", none};
%! for row = bad'
%!   assert (check (row{2:3}, model){1}, row{1});
%! end
%!test
%! % of the value 0 no share helps; of the others it does, and is said apart
%! models = setfield (model, 'fields', {'a', 'w', 'x'});
%! text = "name,value\na,0\nw,0\nx,3\n";
%! assert (check (text, none, models), {'measuredTol', 'measuredTol'});
%! assert (check (text, tolRes, models), {'measuredTol'});
%! assert (isempty (check ("name,value,tol\na,0,0.1\nw,0,0.1 abs\nx,3,\n", ...
%!                         tolRes, models)));
%!test
%! models = struct ('name', {'Toy', 'Drum'}, 'folder', '', 'count', NaN, ...
%!                  'fields', {{}});
%! text = "model,name,value,tol\nToy,a,1,0.1\n";
%! assert (check (text, none, models), {'measuredModel'});
%! assert (isempty (check ([text, "Drum,a,1,0.1\n"], none, models)));
%! assert (check ([text, "Drum,densityP,1,0.1\n"], none, models), ...
%!         {'measuredName'});
%! % a column that is missing is said once
%! text = "model,name,value\nToy,a,1\nDrum,a,1\nDrum,b,1\n";
%! assert (check (text, none, models), {'measuredTol'});
%!test
%! folder = tempname ();
%! mkdir (fullfile (folder, 'gap', 'next'));
%! file = fullfile (folder, 'gap', 'next', 'B.csv');
%! writeAtomic (file, "model,name,value,tol\nB,w,3,0.1\nB,w,5,0.1\nB,v,,0.1\n");
%! raw = struct ('folder', folder, 'further', {{'B'}});
%! raw.optim = struct ('targetVal', {{[1, 2]}}, 'tolRes', 0.1);
%! models = struct ('name', {'A', 'B'}, 'count', {2, 5}, 'folder', '');
%! [p, found] = checkMeasuredTable (raw, models, {});
%! assert (isempty (p));
%! assert (found.sizes, [2, 1]);
%! assert ({found.groups.name, found.groups.value}, {'B_w', 4});
%! writeAtomic (file, "model,name,value,tol\nB,w,x3,0.1\n");
%! p = checkMeasuredTable (raw, models, {});
%! assert (p.id, 'DEcalioc:checkCase:measuredNumber');
%! assert (! isempty (strfind (p.message, 'gap/next/B.csv, line 2, value')));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
