% WRITEGAPJSON  Writes the diagnosis for other programs: gap/gap.json.
%
% CALL: V = writeGapJson (DIAGNOSIS, CASE)
%
%   DIAGNOSIS  of diagnoseMatrices
%   CASE       see newCase; the files go to its folder gap/
%   V          see decideCase: what is written as verdict
%
% The fields are described in docs/gap.md. gap/calibrated.head gets the model
% variables, and the parameters and variables of the effect (or pair) as they
% were fitted together; it is not written where no cure was tried.

function v = writeGapJson (diagnosis, Case)
  folder = fullfile (Case.folder, 'gap');
  [~, ~] = mkdir (folder);
  out = struct ('where', whereOf (diagnosis), 'which', whichOf (diagnosis));
  out.howFar = howFarOf (diagnosis.howFar, diagnosis.gapProblem);
  out.fingerprint = fingerprintOf (diagnosis);
  next = diagnosis.next;
  out.next = arrayfun (@(t) struct ('test', t.test, 'gain', t.gain, ...
                                    'cost', t.cost), next(:)', ...
                       'UniformOutput', false);
  out.level = [];
  if isfield (diagnosis, 'level')
    out.level = diagnosis.level;
  end
  out.reference = changeOf (diagnosis);
  out.demRuns = struct ('sets', diagnosis.runs.spent, ...
                        'failedSets', diagnosis.runs.failed);
  for name = {'new', 'reused', 'failed', 'coreSeconds'}
    out.demRuns.(name{1}) = diagnosis.budget.(name{1});
  end
  calibration = fullfile (Case.folder, 'results', 'calibration.json');
  gap = jsondecode (jsonencode (out));
  v = decideCase (readJsonFile (calibration), gap);
  out.verdict = v;
  writeAtomic (fullfile (folder, 'gap.json'), [jsonencode(out), "\n"]);
  writeHeadOf (gap, Case);
end

function s = fingerprintOf (diagnosis)
  own = diagnosis.fingerprint;
  names = diagnosis.gapProblem.targetNames(own.target);
  s = struct ('targets', {names}, 'measured', own.measured, ...
              'effects', struct ());
  for k = 1:rows (own.effects)
    name = matlab.lang.makeValidName (diagnosis.screen.names{k});
    s.effects.(name) = own.effects(k, :);
  end
end

function s = whereOf (diagnosis)
  where = diagnosis.where;
  gapProblem = diagnosis.gapProblem;
  s = struct ('p', where.p, 'noiseFloor', []);
  noise = sqrt (diag (where.budget.covariance))';
  ok = isfinite (gapProblem.value) & gapProblem.value ~= 0;
  s.noiseFloor = sqrt (mean ((noise(ok) ./ gapProblem.value(ok)).^2));
  s.targets = {};
  for i = 1:numel (gapProblem.used)
    t = gapProblem.used(i);
    s.targets{end + 1} = target (gapProblem, t, 'calibrate', where.t(i), ...
                                 1 - where.absorbability(i), where.blind(i));
    s.targets{end}.p = where.pTarget(i);
    s.targets{end}.size = where.size(i);
  end
  for i = 1:numel (gapProblem.heldOut)
    t = gapProblem.heldOut(i);
    s.targets{end + 1} = target (gapProblem, t, 'holdout', where.held.z(i), ...
                                 1, false);
    s.targets{end}.p = where.held.p(i);
    s.targets{end}.size = abs (where.held.z(i));
  end
  s.models = arrayfun (@(b) struct ('model', gapProblem.benchNames{b.bench}, ...
                                    'p', b.p, 'size', b.size), ...
                       where.benches, ...
                       'UniformOutput', false);
  s.params = cell2struct (num2cell (where.params(:)), gapProblem.names(:), 1);
  s.atLimit = where.side.atLimit;
  s.out = where.out;
  s.neverRun = where.neverRun;
  s.surrogateShare = mean (where.side.share(gapProblem.used));
  s.absorbed = where.absorbed;
  s.unabsorbed = where.unabsorbed;
end

function s = target (gapProblem, t, role, z, unabsorbed, blind)
  s = struct ('model', gapProblem.benchNames{gapProblem.bench(t)}, ...
              'name', gapProblem.targetNames{t}, 'role', role, 'z', z, ...
              'unabsorbed', unabsorbed, 'blind', blind);
end

function s = whichOf (diagnosis)
  w = diagnosis.which;
  s = struct ('verdict', w.verdict, 'reason', w.reason, 'p', w.gateP);
  s.guard = w.guard;
  s.effects = w.effects;
  s.together = w.together;
  s.lookAlike = w.lookAlike;
  s.oddsAgainstLookAlike = w.exclude;
  s.partners = w.partners;
  s.likely = w.likely;
  s.posterior = w.posterior;
  s.probability = rmfield (w.posterior, {'null', 'unlisted'});
  s.resembles = w.resembles;
  s.integration = w.numbers;
  s.cannotSee = [w.cannotSee, diagnosis.screen.untested];
  s.groups = w.groups;
  s.siblings = w.siblings;
  s.strength = struct ();
  for k = 1:numel (w.strength)
    name = matlab.lang.makeValidName (w.strength(k).name);
    s.strength.(name) = strengthOf (w.strength(k), ...
                                    diagnosis.screen.smallest(k), ...
                                    diagnosis.gapProblem);
  end
  s.priorSpread = w.priorSpread;
  s.expected = w.expected;
end

% What cannot be seen has no interval: its runs say nothing of its strength.
function s = strengthOf (own, smallest, gapProblem)
  isSeen = isfinite (smallest);
  own.interval90(~isSeen) = NaN;
  own.values(2:3, ~isSeen(ones (1, columns (own.values)))) = NaN;
  s = struct ('value', own.value, 'interval90', own.interval90, ...
              'smallestSeen', smallest, 'variables', struct (), ...
              'seen', isSeen);
  for j = 1:numel (own.variables)
    s.variables.(own.variables{j}) = own.values(:, j)';
  end
  e = gapProblem.effects(strcmp ({gapProblem.effects.name}, own.name));
  s.label = own.name;
  s.unit = '';
  if isfield (e, 'label')
    s.label = e.label;
    s.unit = e.unit;
  end
  [s.text, s.amount] = deal ('');
  if columns (own.values) == 1
    [s.text, s.amount] = effectText (s.label, s.unit, own.values(:, 1));
  end
end

function s = howFarOf (cure, gapProblem)
  s = struct ('effect', '', 'before', NaN, 'after', NaN, 'floor', NaN, ...
              'closure', NaN, 'interval90', [NaN, NaN], 'heldOut', [], ...
              'placebos', {{}}, 'targets', {{}}, 'verifiedByDEM', false);
  if isempty (cure)
    return
  end
  for field = {'effect', 'before', 'after', 'floor', 'floorAfter', ...
               'closure', 'interval90', 'gapP', 'largestZ', 'removable', ...
               'heldOut', 'verifiedByDEM', 'worstZ'}
    s.(field{1}) = cure.(field{1});
  end
  if isfield (s.heldOut, 'free')
    s.heldOut = rmfield (s.heldOut, 'free');
  end
  s.placebos = num2cell (cure.placebos);
  s.targets = {};
  for one = cure.targets
    t = one.target;
    s.targets{end + 1} = struct ('model', ...
                                 gapProblem.benchNames{gapProblem.bench(t)}, ...
                                 'name', gapProblem.targetNames{t}, ...
                                 'role', 'calibrate', ...
                                 'measured', gapProblem.value(t), ...
                                 'before', one.before, 'after', one.after, ...
                                 'sdBefore', one.sdBefore, 'sd', one.sd);
    if ismember (t, gapProblem.heldOut)
      s.targets{end}.role = 'holdout';
    end
  end
  names = strsplit (cure.effect, ' + ');
  s.strength = cell2struct (num2cell (cure.phi(:)), names(:), 1);
  s.values = struct ();
  for k = 1:numel (names)
    e = gapProblem.effects(strcmp ({gapProblem.effects.name}, names{k}));
    E = valuesOfStrength (e, cure.phi(k));
    for j = 1:numel (E)
      s.values.(e.variables{j}) = E(j);
    end
  end
  s.params = struct ();
  for j = 1:numel (gapProblem.names)
    s.params.(gapProblem.names{j}) = cure.params(:, j)';
  end
end

function writeHeadOf (gap, Case)
  effect = jsonAt (gap, {'howFar', 'effect'});
  params = jsonAt (gap, {'howFar', 'params'});
  values = jsonAt (gap, {'howFar', 'values'});
  if ~ischar (effect) || isempty (effect) || ~isstruct (params) || ...
     ~isstruct (values)
    return
  end
  v = Case.modelVars;
  set = zeros (1, numel (Case.names));
  for j = 1:numel (set)
    both = jsonAt (params, {Case.names{j}});
    if numel (both) < 2
      return
    end
    set(j) = both(2);
  end
  v = designVariables (v, set, Case.names);
  for name = fieldnames (values)'
    v.(name{1}) = values.(name{1});
  end
  text = sprintf ("# parameters fitted together with %s\n", effect);
  writeAtomic (fullfile (Case.folder, 'gap', 'calibrated.head'), ...
               [text, headLines(v)]);
end

%!test
%! % a planted cause: it has the print of the gap, another one has not
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0, 0]);
%! d = diagnoseMatrices (given, data, struct ('bootstrap', 49, 'trials', 0, ...
%!                                            'twins', 60));
%! P = d.fingerprint;
%! far = @(name) norm (P.effects(strcmp (d.screen.names, name), :) - ...
%!                     P.measured) / norm (P.measured);
%! assert (far ('spread') < 0.3);
%! assert (far ('size') > 0.5);
%! % the files of its diagnosis
%! Case = struct ('folder', tempname (), 'modelVars', struct ('c', 3), ...
%!                'names', {d.gapProblem.names});
%! mkdir (Case.folder);
%! v = writeGapJson (d, Case);
%! writeGapTables (d, Case);
%! read = @(name) fullfile (Case.folder, 'gap', name);
%! gap = jsondecode (fileread (read ('gap.json')));
%! assert (gap.verdict.word, v.word);
%! assert (gap.howFar.effect, 'spread');
%! head = headDefaults (read ('calibrated.head'));
%! assert (head.c, 3);
%! assert (head.spread, gap.howFar.values.spread, 1e-9);
%! assert (head.(Case.names{1}), gap.howFar.params.(Case.names{1})(2), 1e-9);
%! [names, cells] = readCsvTable (read ('targets.csv'));
%! assert (rows (cells), numel (gap.where.targets));
%! assert (str2double (cells(:, strcmp (names, 'z')))', ...
%!         [gap.where.targets.z], 1e-3);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');
