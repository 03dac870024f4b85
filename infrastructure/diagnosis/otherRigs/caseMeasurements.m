% CASEMEASUREMENTS  Tests that a case does not have but could.
%
% CALL: TESTS = caseMeasurements (CASE, SAY)
%
%   CASE   see newCase, with effects
%   SAY    function handle that takes one line of text
%   TESTS  1 x m struct, candidates of tryMeasurements: the toolbox's other benches
%          that have the same contact law and grains of about the same size,
%          and for each bench of CASE the values of settings.csv
%
% Each is a model of its own: its folder gap/next/DEMmodels/NAME is made here, a
% copy of the bench with the value in data.head, so that a run's key holds it;
% where a place along a series (results.csv) is the value of the variable, it
% follows. scatter.csv of a bench (name, mean, sd) says how its results scatter
% from run to run. LINES of a candidate are the rows of measured.csv that its
% measurement would fill. A case with conditions has no such tests.

function tests = caseMeasurements (Case, say)
  tests = [];
  if ~isempty (Case.conditions)
    return
  end
  for bench = [otherBenches(Case), otherSettings(Case)]
    tests = [tests, candidate(Case, bench, say)];
  end
end

% The first value of every variable, then the second ones.
function list = otherSettings (Case)
  list = [];
  place = zeros (1, 0);
  taken = [Case.names(:)', Case.effectVars(:)'];
  for k = 1:numel (Case.models)
    model = Case.models(k);
    known = headDefaults (fullfile (model.folder, 'data.head'));
    known = mergeFields (known, Case.modelVars);
    for s = model.settings
      % what the calibration or an effect sets is no setting of the rig
      isFree = ~any (strcmp (s.variable, taken)) && ...
               isfield (known, s.variable);
      if ~isFree
        continue
      end
      old = known.(s.variable);
      for value = s.values(s.values ~= old)
        text = sprintf (s.text, quantity (value, s.unit));
        name = [model.name, '_', s.variable, '_', quantity(value, s.unit)];
        list = [list, struct('name', regexprep (name, '[^\w.+-]', ''), ...
                             'source', model.folder, 'origin', k, ...
                             'variable', s.variable, 'unit', s.unit, ...
                             'value', value, 'old', old, 'change', ...
                             struct (s.variable, value), 'test', ...
                             ['measure ', model.name, ' with ', text])];
        place(end + 1) = find (s.values == value, 1);
      end
    end
  end
  [~, order] = sort (place);
  list = list(order);
end

% What the grains are is taken over from the first model that declares it.
function list = otherBenches (Case)
  list = [];
  heads = arrayfun (@(m) headDefaults (fullfile (m.folder, 'data.head')), ...
                    Case.models, 'UniformOutput', false);
  known = Case.modelVars;
  for head = heads(end:-1:1)
    known = mergeFields (head{1}, known);
  end
  for file = glob (fullfile (Case.root, 'DEMmodels', '*', 'scatter.csv'))'
    folder = fileparts (file{1});
    [~, name] = fileparts (folder);
    own = headDefaults (fullfile (folder, 'data.head'));
    % parameters were calibrated for grains of this size: a factor of 1.5 is near
    if any (strcmp (name, {Case.models.name})) || ...
       ~all (isfield (own, Case.names)) || ~hasLaw (folder, Case) || ...
       ~(abs (log (own.radiusP / known.radiusP)) < log (1.5))
      continue
    end
    change = struct ();
    for v = fieldnames (own)'
      % names end in P or W for grains and their walls: the rest belongs to the rig
      isGrain = ~isempty (regexp (v{1}, '(P|W)$', 'once'));
      if isGrain && isfield (known, v{1}) && known.(v{1}) ~= own.(v{1})
        change.(v{1}) = known.(v{1});
      end
    end
    if numfields (change) > 0
      name = [name, '_grains'];
    end
    list = [list, struct('name', name, 'source', folder, 'origin', 0, ...
                         'variable', '', 'unit', '', 'value', [], 'old', [], ...
                         'change', change, 'test', ['measure the bench ', ...
                                                    name])];
  end
end

function yes = hasLaw (folder, Case)
  yes = false;
  file = fullfile ('effects', 'material.inc');
  law = checkReadText (fullfile (folder, file));
  for model = Case.models
    yes = yes || (~isempty (law) && ...
                  strcmp (law, checkReadText (fullfile (model.folder, file))));
  end
end

function test = candidate (Case, bench, say)
  own = caseOf (Case, bench);
  T = numel (own.targets);
  head = headDefaults (fullfile (own.models.folder, 'data.head'));
  test = struct ('test', bench.test, 'model', own.models.name, ...
                 'variable', bench.variable, 'value', bench.value, ...
                 'trials', 3, 'cost', own.models.cost, ...
                 'origin', NaN (1, T), 'noise', NaN (1, T), ...
                 'size', NaN (1, T), 'sd', NaN (1, T));
  if bench.origin > 0
    test.origin = find ([Case.targets.model] == bench.origin);
  else
    [test.noise, test.size] = runScatter (bench.source);
  end
  given = newProblem (own);
  test.effects = struct ('offset', {}, 'matrix', {});
  test.isExpressed = true (1, numel (Case.effects));
  for k = 1:numel (Case.effects)
    test.effects(k) = struct ('offset', given.effects(k).offset, ...
                              'matrix', given.effects(k).matrix);
    test.isExpressed(k) = all (isfield (head, Case.effects(k).variables));
  end
  test.evaluate = newCaseEvaluate (own, say);
  test.lines = measuredLines (own, bench, test.trials);
end

function lines = measuredLines (own, bench, trials)
  lines = {};
  info = targetInfo (own);
  for k = 1:numel (own.targets)
    t = own.targets(k);
    [name, at, sd, tol] = deal (t.result, '', '', '0.05');
    if isempty (name)
      name = resultInfo (own.models.folder)(t.index).name;
    end
    % a point of a curve is named by its series in measured.csv
    name(1:numel (name) * strcmp (name, t.series)) = '';
    if ~isempty (t.series)
      at = sprintf ('%.10g', t.at);
    end
    if bench.origin > 0
      tol = [sprintf('%.4g', t.tol), repmat(' abs', 1, t.isAbsolute)];
      sd = repmat (sprintf ('%.4g', t.sd), 1, t.sd > 0);
    end
    line = strjoin ({own.models.name, name, t.series, at, '', sd, ...
                     info(k).unit, tol}, ',');
    lines = [lines, repmat({line}, 1, trials)];
  end
end

% The case of this bench alone.
function own = caseOf (Case, bench)
  own = Case;
  k = max (bench.origin, 1);
  own.models = Case.models(k);
  own.models.name = bench.name;
  own.models.folder = benchFolder (Case, bench);
  own.models.seconds = [];
  if bench.origin > 0
    own.targets = Case.targets([Case.targets.model] == k);
    moved = [own.targets.at];
    % a place along a series that is the value of the variable follows it
    moved(moved == bench.old) = bench.value;
    moved = num2cell (moved);
    [own.targets.at] = moved{:};
    if ~isempty (own.models.readings)
      [own.models.readings.at] = moved{:};
    end
  else
    own.models.cpu = 1;
    % nobody has said what a measurement on it costs
    own.models.cost = median ([Case.models.cost]);
    [own.models.readings, own.models.timeout] = deal ([], NaN);
    info = resultInfo (bench.source);
    own.targets = repmat (Case.targets(1), 1, numel (info));
    index = num2cell (1:numel (info));
    [own.targets.index] = index{:};
    [own.targets.name] = info.name;
    [own.targets.unit, own.targets.result, own.targets.series] = deal ('');
    [own.targets.at] = deal (NaN);
  end
  [own.targets.model] = deal (1);
  [own.targets.modelName] = deal (bench.name);
  [own.targets.value] = deal (NaN);
  [own.targets.role] = deal ('unmeasured');
  [own.targets.curve] = deal (0);
  [own.targets.correlation] = deal (0);
  own.models.nTargets = numel (own.targets);
end

%!test
%! % settings of a bench and of the toolbox's benches, each a model of its own
%! raw = standInCase (tempname ());
%! folder = fullfile (raw.folder, 'DEMmodels', 'First');
%! writeAtomic (fullfile (folder, 'data.head'), ...
%!              [fileread(fullfile (folder, 'data.head')), ...
%!               "variable w equal 1\n"]);
%! writeAtomic (fullfile (folder, 'settings.csv'), ...
%!              ["variable,unit,values,text\nw,m,1 2 0.045,a slot of %s\n", ...
%!               "a,,7,a of %s\n"]);
%! Case = newCase (raw);
%! Case.effects = resolveEffects ({'gain', ...
%!   struct('name', 'x', 'variables', {{'e'}}, 'neutral', 0, ...
%!          'limits', [0; 5]), 'tilt'});
%! Case.effectVars = {'e', 'tiltAngle'};
%! % those of the case's own: not a, which is calibrated, nor w as it is; the
%! % benches of the toolbox have another law
%! list = caseMeasurements (Case, @(text) []);
%! assert ({list.model}, {'First_w_2m', 'First_w_45mm'});
%! assert (list(2).test, 'measure First with a slot of 45 mm');
%! assert (list(1).origin, [1, 2]);
%! assert (list(1).isExpressed, [true, true, false]);
%! assert (numel (list(1).lines), 6);
%! assert (list(1).lines{1}, 'First_w_2m,First_1,,,,,,0.01');
%! [~, budget] = newEvaluate (@(P, E, r) 0);
%! budget.left = 5;
%! [Z, budget] = list(2).evaluate ([1, 2], [3, 0], 1, 'next', budget);
%! assert (Z, [6, 5]);
%! assert (budget.left, 4);
%! head = fileread (fullfile (Case.folder, 'gap', 'next', 'DEMmodels', ...
%!                            'First_w_45mm', 'data.head'));
%! assert (! isempty (strfind (head, 'variable w equal 0.045')));
%! Case.conditions = {'wet'};
%! assert (isempty (caseMeasurements (Case, @(text) [])));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (raw.folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
