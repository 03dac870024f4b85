% NEWTARGETS  The targets of a case, from measured.csv or from optim.
%
% CALL: TARGETS = newTargets (OPTIM, NAMES, FOUND)
%
%   OPTIM    scalar struct, the optim of loadInput, checked
%   NAMES    1 x M cell, names of the models
%   FOUND    scalar struct: groups of measured.csv, which go before
%            optim.targetVal, and sizes, see checkCase. Where there are both,
%            the groups are of further models (filledMeasurements)
%   TARGETS  1 x T struct in the order of the models: model (number), modelName,
%            index (which result of the run), and name, value, sd, tol, role,
%            trials, correlation as in optim. From measured.csv also:
%     role        'unmeasured': only predicted, value NaN
%     isAbsolute  tol and residual have the unit of the value
%     scatter     sd comes from repeated trials and includes their packings
%     curve       number of the curve (0: none)
%     each        1 x n, the repeated trials
%     shared      part of sd that its sessions (cell of names) make
%     days, and the freedoms  see varianceComponents
%     changed     1 x C struct, in each of Case.conditions: value, sd, trials,
%                 scatter, shared, days, freedoms, scatterRatio, scatterP, swept
%     result, series, at, unit ('', NaN: none), given (unit in measured.csv)

function targets = newTargets (optim, names, found)
  groups = found.groups;
  default = inputFields ('defaults');
  if isempty (groups)
    groups = fromCells (optim, names, found.sizes, default);
  elseif groups(1).model > 1
    n = groups(1).model - 1;
    first = fromCells (optim, names(1:n), found.sizes(1:n), default);
    groups = [first, rmfield(groups, {'line', 'file', 'each', 'mixed'})];
  else
    groups = rmfield (groups, {'line', 'file'});
  end
  counts = arrayfun (@(k) sum ([groups.model] == k), 1:numel (names));
  lengths = perTarget (asLengths (givenField (optim, 'correlation', {})), ...
                       counts, -1);
  seen = zeros (size (counts));
  targets = cell (1, numel (groups));
  for j = 1:numel (groups)
    g = groups(j);
    seen(g.model) = seen(g.model) + 1;
    index = seen(g.model);
    t = mergeFields (struct ('model', g.model, ...
                             'modelName', names{g.model}, 'index', index, ...
                             'correlation', lengths{g.model}(index)), g);
    if isnan (t.tol)
      t.tol = givenField (optim, 'tolRes', default.tolRes);
    end
    targets{j} = t;
  end
  targets = withCurves ([targets{:}]);
end

% Numbers the curves: the series of a model is one. Its errors are alike, as far as
% its residuals say, where the user gives no length.
function targets = withCurves (targets)
  series = arrayfun (@(t) sprintf ('%d|%s', t.model, t.series), targets, ...
                     'UniformOutput', false);
  [~, number] = ismember (series, unique (series, 'stable'));
  number(cellfun (@isempty, {targets.series})) = 0;
  parts = num2cell (number);
  [targets.curve] = parts{:};
  isOpen = [targets.correlation] < 0;
  [targets(isOpen & number == 0).correlation] = deal (0);
  [targets(isOpen & number > 0).correlation] = deal (NaN);
end

% The published loadInput returns the values of all models as one column.
function groups = fromCells (optim, models, counts, default)
  values = perTarget (givenField (optim, 'targetVal', 0), counts, NaN);
  tols = perTarget (givenField (optim, 'tolRes', 0), counts, 0);
  sds = perTarget (givenField (optim, 'targetStd', []), counts, ...
                   default.targetStd);
  trials = perTarget (givenField (optim, 'trials', []), counts, ...
                      default.trials);
  names = givenField (optim, 'targetName', {});
  roles = givenField (optim, 'role', {});
  groups = [];
  for k = 1:numel (models)
    for i = 1:counts(k)
      name = textOf (names, k, i, sprintf ('%s_%d', models{k}, i));
      g = struct ('model', k, 'name', name, 'value', values{k}(i), ...
                  'sd', sds{k}(i), 'tol', tols{k}(i), ...
                  'role', textOf (roles, k, i, default.role), ...
                  'trials', trials{k}(i), 'isAbsolute', false, ...
                  'scatter', false, 'unit', '', 'given', '', ...
                  'shown', struct ('unit', '', 'factor', 1), ...
                  'result', '', ...
                  'series', '', 'at', NaN, 'changed', [], ...
                  'shared', 0, 'days', [], 'freedom', Inf, ...
                  'commonFreedom', Inf, 'sessionFreedom', Inf, ...
                  'scatterRatio', NaN, 'scatterP', NaN, 'swept', false, ...
                  'sessions', {{}});
      groups = [groups, g];
    end
  end
end

% NaN stands for a length that is to be estimated, 0 for independent errors.
function lengths = asLengths (lengths)
  for k = 1:numel (lengths)
    if ischar (lengths{k})
      lengths{k} = NaN;
    else
      lengths{k}(isnan (lengths{k})) = 0;
    end
  end
end

function text = textOf (nested, k, i, default)
  text = default;
  if numel (nested) >= k && numel (nested{k}) >= i && ~isempty (nested{k}{i})
    text = nested{k}{i};
  end
end

% Spreads VALUES on the targets of each model: a cell of vectors, {k}(i) for
% target i of model k, {k} one number for a model or []; or one vector of all
% targets; or one number for all; [] for none.
function parts = perTarget (values, counts, default)
  if isempty (values)
    values = default;
  end
  if ~iscell (values) && isscalar (values)
    values = repmat ({values}, 1, numel (counts));
  elseif ~iscell (values)
    values = mat2cell (values(:)', 1, counts);
  end
  parts = arrayfun (@(n) repmat (default, 1, n), counts(:)', ...
                    'UniformOutput', false);
  for k = 1:numel (values)
    part = double (values{k}(:)');
    if isscalar (part)
      part = repmat (part, 1, counts(k));
    end
    parts{k}(1:numel (part)) = part;
  end
end

%!function t = ofTable (text, optim, sizes)
%!  if nargin < 3
%!    sizes = [];
%!  end
%!  file = tempname ();
%!  writeAtomic (file, text);
%!  groups = groupMeasured (readMeasured (file, {'A', 'B'}), {'A', 'B'});
%!  t = newTargets (optim, {'A', 'B'}, struct ('groups', groups, ...
%!                                                 'sizes', sizes));
%!endfunction
%!test
%! t = ofTable (...
%!              ["model,name,series,at,value,sd,tol\nB,b,,,0,,0.5\n", ...
%!               "A,,w,1,4,0.2,\nA,,w,2,,,\nA,a,,,5,,1 abs\nA,a,,,7,,\n"], ...
%!              struct ('tolRes', 0.1));
%! assert ({t.name}, {'w@1', 'w@2', 'a', 'b'});
%! assert ([t.model], [1, 1, 1, 2]);
%! assert ([t.index], [1, 2, 3, 1]);
%! assert ([t.value], [4, NaN, 6, 0]);
%! assert ([t.tol], [0.1, 0.1, 1, 0.5]);
%! assert ([t.isAbsolute], [false, false, true, true]);
%! assert ([t.trials], [1, 1, 2, 1]);
%! assert ({t.role}, {'calibrate', 'unmeasured', 'calibrate', 'calibrate'});
%! assert ([t.correlation], [NaN, NaN, 0, 0]);
%! assert ([t.curve], [1, 1, 0, 0]);
%!test
%! % named results that form a series are a curve, in each model another one
%! t = ofTable (["model,name,series,at,value,tol\nA,r1,w,1,4,0.1\nA,r2,w,2,5,0.1\n", ...
%!               "B,,w,1,3,0.1\nB,,w,2,2,0.1\n"], struct ());
%! assert ([t.curve], [1, 1, 2, 2]);
%!test
%! % a name that both models have is told apart, the result is not
%! t = ofTable ("model,name,value,tol\nA,slope,3,0.1\nB,slope,4,0.1\n", ...
%!              struct ());
%! assert ({t.name}, {'A_slope', 'B_slope'});
%! assert ({t.result}, {'slope', 'slope'});
%!test
%! % cells of optim, and the table of a further model
%! t = ofTable ("model,name,value,tol\nB,x,3,0.1\n", ...
%!              struct ('targetVal', {{[1, 2]}}, 'tolRes', {{[0.1, 0.2]}}), ...
%!              [2, 1]);
%! assert ([t.model], [1, 1, 2]);
%! assert ({t.name}, {'A_1', 'A_2', 'x'});
%! assert ([t.tol], [0.1, 0.2, 0.1]);
%!test
%! % the cells of optim give the same fields
%! found = struct ('groups', [], 'sizes', [2, 1]);
%! t = newTargets (struct ('targetVal', {{[1, 2], 3}}, 'tolRes', 0.1, ...
%!                         'trials', {{int8(5), []}}), {'A', 'B'}, found);
%! assert ([t.value], [1, 2, 3]);
%! assert ([t.trials], [5, 5, 1]);
%! assert (any ([t.isAbsolute]), false);
%! assert ({t.name}, {'A_1', 'A_2', 'B_1'});
%! assert ([t.curve], [0, 0, 0]);

% SPDX-License-Identifier: GPL-3.0-only
