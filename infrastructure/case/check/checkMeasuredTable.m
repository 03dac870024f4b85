% CHECKMEASUREDTABLE  Checks measured.csv, where a case has one.
%
% CALL: [P, FOUND] = checkMeasuredTable (RAW, MODELS, TAKEN)
%
%   RAW     see readInput: optim and what readConditions reads
%   MODELS  1 x M struct array, see checkFindModels
%   TAKEN   cell of names that a target may not have: variables
%   P       1 x n faults, see checkFault
%   FOUND   struct sizes (1 x M, targets of each model; [] where they make no
%           sense), groups and conditions, see groupMeasured
%
% The table stands in the place of the fields of optim that are given target by
% target. optim.tolRes may be one number: the tolerance where tol is empty.
%
% Reasons: measuredTwice measuredTol measuredModel measuredName measuredResult
% noCalibrateTarget, and those of readConditions and groupMeasured

function [p, found] = checkMeasuredTable (raw, models, taken)
  optim = raw.optim;
  found = struct ('sizes', [], 'groups', [], 'conditions', {{}});
  p = checkTwice (optim);
  [lines, q] = readConditions (raw, {models.name});
  p = [p, q];
  if isempty (lines) || any ([lines.model] == 0) || ...
     (~isempty (q) && any (strcmp ({q.id}, ...
                                   'DEcalioc:checkCase:measuredCondition')))
    return
  end
  [groups, q, conditions] = groupMeasured (lines, {models.name});
  p = [p, q, checkTolerances(groups, lines, optim), ...
       checkNames(groups, [taken, {'model', 'seed'}]), ...
       checkResults(groups, models)];
  if ~any (strcmp ({groups.role}, 'calibrate'))
    p(end + 1) = checkFault ('noCalibrateTarget', 'measured.csv', ...
                             'at least one target to calibrate on', ...
                             'none that is measured and not held out', ...
                             'Write calibrate into the column role.');
  end
  sizes = arrayfun (@(k) sum ([groups.model] == k), 1:numel (models));
  for k = find (sizes == 0)
    p(end + 1) = checkFault ('measuredModel', 'measured.csv', ...
                             ['a line of the model ', models(k).name], ...
                             'none', ...
                             'Add one, or take it out of Input.model.');
  end
  found = struct ('sizes', sizes, 'groups', groups, ...
                  'conditions', {conditions});
end

function p = checkTwice (optim)
  p = checkFault ();
  fields = {'targetVal', 'targetName', 'targetStd', 'trials', 'role'};
  isGiven = @(f) isfield (optim, f) && ~checkIs ('nothing', optim.(f));
  given = fields(cellfun (isGiven, fields));
  if isGiven ('tolRes') && ~(checkIs ('number', optim.tolRes) && ...
                             optim.tolRes > 0 && optim.tolRes < 1)
    given{end + 1} = 'tolRes';
  end
  for name = given
    p(end + 1) = checkFault ('measuredTwice', ['optim.', name{1}], ...
                             ['nothing, for measured.csv in the case ' ...
                              'folder says it (tolRes: one number ' ...
                              'between 0 and 1)'], ...
                             checkShow (optim.(name{1})), ...
                             'Take the field out, or measured.csv away.');
  end
end

function p = checkTolerances (groups, lines, optim)
  p = checkFault ();
  default = NaN;
  if isfield (optim, 'tolRes') && checkIs ('number', optim.tolRes)
    default = optim.tolRes;
  end
  isAsked = strcmp ({groups.role}, 'calibrate') & isnan ([groups.tol]);
  for g = groups(isAsked)
    isBad = any ([lines([lines.line] == g.line).saysTol]);
    if ~isBad && (isnan (default) || g.value == 0)
      p(end + 1) = checkFault ('measuredTol', ...
                               sprintf ('measured.csv, line %d, tol', ...
                                        g.line), ...
                               ['a tolerance (0.02 or 2%; of the value 0 ' ...
                                'in its unit)'], 'nothing', ...
                               ['Or set optim.tolRes = 0.02; for all ' ...
                                'that have none.']);
    end
  end
end

function p = checkNames (groups, taken)
  p = checkFault ();
  names = {groups.name};
  for k = 1:numel (groups)
    where = sprintf ('measured.csv, line %d, name', groups(k).line);
    if any (strcmp (names{k}, names(1:k - 1)))
      p(end + 1) = checkFault ('measuredName', where, ...
                               'a name for each target', ...
                               [checkShow(names{k}), ' twice'], ...
                               ['The names are columns of runs.csv: ' ...
                                'rename one of the two.']);
    elseif any (strcmp (names{k}, taken))
      p(end + 1) = checkFault ('measuredName', where, ...
                               'a name that no variable has', ...
                               checkShow (names{k}), ...
                               'Rename the target: both are columns.');
    end
  end
end

% What is known of the results: results.csv, and the fields that getResults
% returned without a run. A series of results.csv is measured as a series only.
function p = checkResults (groups, models)
  p = checkFault ();
  for g = groups
    m = models(g.model);
    [names, series] = namesOf (m.folder);
    known = unique ([names, m.fields]);
    if ~isempty (g.series)
      known = unique ([known, series]);
    end
    if isempty (m.folder) || (isempty (known) && isnan (m.count)) || ...
       any (ismember ({g.result, g.series}, known))
      continue
    end
    p(end + 1) = checkFault ('measuredResult', ...
                             sprintf ('measured.csv, line %d', g.line), ...
                             ['a result of ', m.name, ': ', ...
                              strjoin(known, ', ')], ...
                             checkShow (g.result), ...
                             strtrim ([checkNearest(g.result, known), ...
                                       ' Name it in results.csv of the ' ...
                                       'model, or let getResults return ' ...
                                       'a struct with this field.']));
  end
end

function [names, series] = namesOf (folder)
  [names, series] = deal ({});
  try
    info = resultInfo (folder);
  catch
    return
  end
  if ~isempty (info)
    names = {info.name};
    series = unique ({info.series});
    series = series(~cellfun (@isempty, series));
  end
end

%!function p = check (text, optim, model)
%!  folder = tempname ();
%!  mkdir (folder);
%!  if nargin < 3
%!    model = struct ('name', 'Toy', 'folder', folder, 'count', 1, ...
%!                    'fields', {{'a', 'w'}});
%!  end
%!  writeAtomic (fullfile (folder, 'measured.csv'), text);
%!  raw = struct ('folder', folder, 'Input', struct (), 'optim', optim);
%!  p = checkMeasuredTable (raw, model, {'densityP'});
%!  confirm_recursive_rmdir (false, 'local');
%!  rmdir (folder, 's');
%!endfunction
%!function same (p, reason)
%!  assert (p(1).id, ['DEcalioc:checkCase:', reason]);
%!endfunction
%!test
%! assert (isempty (check ("name,value,tol\na,1,0.1\n", struct ())));
%! assert (isempty (check ("name,value\na,1\n", struct ('tolRes', 0.1))));
%! assert (isempty (check ("name,series,at,value\n,w,1,3\n,w,2,4\n", ...
%!                         struct ('tolRes', 0.1))));
%!test
%! same (check ("name,value\na,1\n", struct ()), 'measuredTol');
%! same (check ("name,value\na,0\n", struct ('tolRes', 0.1)), 'measuredTol');
%! same (check ("name,value\na,1\n", struct ('tolRes', {{0.1}})), ...
%!       'measuredTwice');
%! same (check ("name,value,tol\na,1,0.1\n", struct ('targetVal', 3)), ...
%!       'measuredTwice');
%! same (check ("name,value,tol\nb,1,0.1\n", struct ()), 'measuredResult');
%! same (check ("name,value,tol\na,,0.1\n", struct ()), 'noCalibrateTarget');
%! same (check ("name,value,tol,role\na,1,0.1,holdout\n", struct ()), ...
%!       'noCalibrateTarget');
%!test
%! models = struct ('name', {'Toy', 'Drum'}, 'folder', '', 'count', NaN, ...
%!                  'fields', {{}});
%! text = "model,name,value,tol\nToy,a,1,0.1\n";
%! same (check (text, struct (), models), 'measuredModel');
%! assert (isempty (check ([text, "Drum,a,1,0.1\n"], struct (), models)));
%! same (check ([text, "Drum,densityP,1,0.1\n"], struct (), models), ...
%!       'measuredName');
%!test
%! % what results.csv names as a series is no result of its own
%! folder = tempname ();
%! mkdir (folder);
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!              "name,kind,unit,series,at,text\ntop,height,m,w,1,t\n");
%! model = struct ('name', 'Toy', 'folder', folder, 'count', 1, ...
%!                 'fields', {{}});
%! assert (isempty (check ("name,value,tol\ntop,1,0.1\n", struct (), model)));
%! assert (isempty (check ("name,series,at,value\n,w,1,3\n,w,2,4\n", ...
%!                         struct ('tolRes', 0.1), model)));
%! faults = check ("name,value,tol\nw,1,0.1\n", struct (), model);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
%! same (faults, 'measuredResult');
