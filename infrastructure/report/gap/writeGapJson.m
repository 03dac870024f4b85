% WRITEGAPJSON  Writes the diagnosis for other programs: gap/gap.json.
%
% CALL: [V, CONDITIONS] = writeGapJson (DIAGNOSIS, CASE)
%
%   DIAGNOSIS  of diagnoseMatrices
%   CASE       see newCase; the files go to its folder gap/
%   V          see decideCase: what is written as verdict
%   CONDITIONS of compareConditions, with code and kind of the verdict; [] for a case
%              without a reference
%
% gap/calibrated.head gets the model variables, and the parameters and variables of
% the effect (or pair) as they were fitted together; it is not written where no cure
% was tried.
%
% Fields of gap.json. Strengths: 0 neutral, 1 the limit further from it (DEM
% effects both ways: 1 upper, -1 lower). {name: x}: one x for each name.
%
%   format  1; it grows where a field changes its meaning or goes. Strengths and their
%     intervals are shares of the range where no unit is said; inUnit has them in it
%   cause {code, kind}, closure {code}, action {code, field, widen, file}: codes for
%     programs; they stay, sentences change (report/words/words.txt)
%   where
%     p, params, atLimit, odd (a test that contradicts all
%              others)
%     out (tests without any result), neverRun (without a finished run),
%     lacking (targets that too many runs lack)
%     surrogateShare (of the noise)
%     targets  [{model, name, role (aside: not followed, see reference), z, unabsorbed
%              (0..1, what parameters cannot
%              hide), blind, p (chance that noise gives a miss this large in any
%              fitted, or in any target not used in the fit), deviation (measured less
%              predicted, over the noise of both), size (without its sign; z also
%              counts what the fit hides), measured, sdMeasured, predicted,
%              sdPredicted}]
%     models   [{model, p, size}], of the whole test
%   which
%     verdict, reason, p, guard, effects, together, sameKind, lookAlike, likely,
%     class, decides (kinds of readings), groups, cannotSee
%     untested [{name, runs, why, beyond}], candidates of which all runs failed (beyond
%              ''), or those that were stronger than the amount beyond
%     oneSided (candidates whose limits leave out one side of the neutral value)
%     partners (probably act with the named one)
%     siblings (look-alikes not listed or without runs)
%     posterior, probability  {null, each effect, unlisted}; both count an effect
%              alone and in pairs, byItself {each effect} only where no likelier one of
%              effects acts; oneOf that one of effects acts
%     said     {posterior, oneOf}, as page and console tell them: where a gap shows, given
%              that there is one, without null
%     cause    [{name, label, question, probability, effects}], what may have made
%              it; name empty: none of these
%     strength {effect: {value, interval90 (none if unseen), smallestSeen,
%              variables {name: [median, lo, hi]}, seen, says (amount: of a named
%              effect; least: so much or more; bound: not more than the upper end;
%              nothing: no runs where it would fit), label, unit, saysName (see
%              describeEffect), kind (causeKind), text, amount (in its unit), seenFrom
%              (the smallest that would be seen in 8 of 10 cases), atEnd (the end of its
%              range, where it stands there), inUnit {value, interval90, smallestSeen} (in
%              its unit; empty for an effect of several variables)}}
%   howFar
%     effect, before, after (deviations, in shares of each target's range)
%     floor (of noise alone), closure, interval90
%     removable (a gap shows; else, or with too few targets, closure is null)
%     heldOut  {these six, of the test data not used in the fit}
%     placebos [{effect, closure, heldOut, logRatio (log density of data not used in
%              the fit, cause over placebo), against (the cause)}]
%     targets  [{model, name, role, measured, allowed, before, after, sdBefore, sd
%              (of measured less before, after)}]
%     verifiedByDEM, params {name: [without, with]}
%     strength {effect: in shares of its range}, values {variable: in the refit}
%   fingerprint, all over noise
%     targets, measured (less simulated without an effect), effects {effect: what
%     it would add, fitted alone}, ofTarget {model: {target: {measured, effects
%     {effect: x}}}}, the same by name
%   next  [{test, gain (bits about the kind of cause), cost, model, variable,
%     value (empty: as it stands), trials, runs (behind the gain), sure, between (two
%     kinds)}], first those worth advising, by gain per optim.cost; last those given
%     up early (sure: false). An empty value (or curve) of measured.csv is a test, too.
%   level, with levels
%     variables, value (the last), finer, shift, shiftSd (expected change at the
%     finer level), ofTarget {model: {target: {shift, shiftSd}}}, the same by name,
%     verdict, effects with that shift (empty: unknown), holds
%   reference, with conditions, else empty
%     condition (of all other fields: of gap/gap.json the first that has changed, else
%              the first), folder (of its files), lack (what the model
%     misses in both, in shares of what parameters move)
%     targets  [{model, name, kind, series, unit (of the result), shown {unit, factor}
%              (as the user gave it), reference, measured, foretold (without a change),
%              modelled (with the effect), z, sd (of measured less reference), simulated
%              (by the calibrated model at the reference), seenFrom (change that would
%              show in 8 of 10 cases), allowed (at the reference), followed
%              (false: the model misses the reference by more, so its change decides
%              nothing, see setAside)}]
%     notMeasured [{model, name}], measured of the reference alone
%     conditions  [{name, verdict, code, kind (as in cause), change, plain (words of
%              its verdict), names (effects that may be said), effects, lookAlike, p, oneOf,
%              said {probability, oneOf} (as of which), probability, strength, interval90,
%              text (a list in the order of effects each), ofEffect {effect: {probability,
%              value, interval90, inUnit, text}}, the same by name}]
%     order  [{effect, more, less, probability}], of two conditions
%     canChange  {candidate: yes, unlikely, no};  origin  what the user says it was
%              (Input.origin), in words
%   thresholds  level, adviseAt (gapOptions): those that the report uses
%   demRuns  sets, failedSets, new, reused, failed, coreSeconds
%   input, verdict: as in calibration.json (docs/data.md); cause of the verdict has
%     kind, word, sentence, where, closed, action, cannotSee, untested

function [v, conditions] = writeGapJson (diagnosis, Case)
  folder = fullfile (Case.folder, 'gap');
  [~, ~] = mkdir (folder);
  write = @(out) writeAtomic (fullfile (folder, 'gap.json'), [jsonencode(out), "\n"]);
  out = resultOf (diagnosis, Case);
  % no result is lost to a sentence
  write (out);
  gap = jsondecode (jsonencode (out));
  [out, v, conditions] = withVerdict (withAmounts (out, diagnosis), diagnosis, Case);
  if isempty (gap.howFar.effect) || isempty (v.cause.names)
    % none of an earlier diagnosis stays
    [~, ~] = unlink (fullfile (folder, 'calibrated.head'));
  else
    writeHeadOf (gap, Case);
  end
  write (out);
end

% All numbers and codes, no sentence.
function out = resultOf (diagnosis, Case)
  out = struct ('format', 1, 'where', whereOf (diagnosis), 'which', whichOf (diagnosis));
  out.howFar = howFarOf (diagnosis.howFar, diagnosis.problem, Case);
  out.thresholds = struct ('level', diagnosis.options.significance, 'adviseAt', ...
                           diagnosis.options.adviseAt);
  out.fingerprint = fingerprintOf (diagnosis);
  next = diagnosis.next(:)';
  [next.sure] = next.isFirm;
  out.next = num2cell (rmfield (next, {'targets', 'gainPerCost', 'lines', 'isFirm'}));
  out.level = levelOf (jsonAt (diagnosis, {'level'}), diagnosis.problem);
  out.reference = changeOf (diagnosis, Case);
  out.demRuns = struct ('sets', diagnosis.runs.spent, ...
                        'failedSets', diagnosis.runs.failed);
  out.demRuns = mergeFields (out.demRuns, diagnosis.budget, ...
                             {'new', 'reused', 'failed', 'coreSeconds'});
  out.input = resultInput (Case);
end

function [out, v, conditions] = withVerdict (out, diagnosis, Case)
  conditions = jsonAt (diagnosis, {'others', 'conditions'});
  if ~isempty (conditions)
    conditions(1).text = eachOf (@(name) shortText (out.which.strength, name), ...
                                 conditions(1).effects);
    conditions(1).ofEffect = ofEffects (conditions(1), out.which.strength);
    out.reference.conditions = forPrograms (conditions);
  end
  stored = storedResult (Case);
  if ~isempty (stored.changed)
    stored.calibration = [];             % of an earlier input
  end
  v = decideCase (stored.calibration, jsondecode (jsonencode (out)));
  out.cause = struct ('code', v.cause.code, 'kind', v.cause.kind);
  out.closure = struct ('code', v.cause.closure);
  out.action = v.todo;
  out.verdict = rmfield (v, 'actionParts');
  out.verdict.numbers = num2cell (v.numbers);     % an empty struct has no JSON
  for name = {'todo', 'without'}
    out.verdict.cause.(name{1}) = asText (v.cause.(name{1}));
  end
  if ~isempty (conditions)
    for name = {'code', 'kind', 'change', 'names', 'plain'}
      conditions(1).(name{1}) = v.cause.(name{1});
    end
    out.reference.conditions = forPrograms (conditions);
  end
end

function list = forPrograms (conditions)
  list = num2cell (rmfield (conditions, 'errors'));
end

% By name what stands in lists in the order of the effects.
function s = ofEffects (one, strengths)
  s = struct ();
  for k = 1:numel (one.effects)
    name = fieldsOf (one.effects{k});
    own = struct ('probability', one.probability(k), 'value', one.strength(k), ...
                  'interval90', one.interval90(k, :), 'text', one.text{k});
    s.(name) = mergeFields (own, strengths.(name), {'inUnit'});
  end
end

% Of a strength that is not known the label alone.
function text = shortText (strengths, name)
  own = strengths.(fieldsOf (name));
  text = own.text;
  if isempty (text) || strcmp (own.says, 'nothing')
    text = own.label;
  end
end

function s = fingerprintOf (diagnosis)
  prints = diagnosis.fingerprint;
  names = fieldsOf (diagnosis.screen.names(1:rows (prints.effects)));
  s = struct ('targets', {diagnosis.problem.targetNames(prints.target)}, ...
              'measured', prints.measured, 'effects', ...
              cell2struct (num2cell (prints.effects, 2), names(:), 1));
  each = eachOf (@(t) struct ('measured', prints.measured(t), 'effects', ...
                              cell2struct (num2cell (prints.effects(:, t)), names(:), 1)), ...
                 1:numel (prints.target));
  s.ofTarget = byTarget (namesOf (diagnosis.problem, prints.target), each);
end

function names = fieldsOf (names)
  names = matlab.lang.makeValidName (names);
end

function s = whereOf (diagnosis)
  where = diagnosis.where;
  problem = diagnosis.problem;
  sd = where.budget;
  target = @(T) mergeFields (withNoise (T, sd.measurement(T.target)), ...
                             T, {'model', 'name', 'role', 'z', 'blind', 'p', 'size', ...
                                 'measured', 'predicted'});
  s = struct ('p', where.p, 'atLimit', {where.side.atLimit}, ...
              'targets', {eachOf(target, diagnosedTargets (diagnosis))}, ...
              'odd', {problem.benchNames(where.conflict.odd)}, ...
              'out', {where.out}, 'neverRun', {where.neverRun}, ...
              'lacking', {where.lacking}, ...
              'surrogateShare', mean (where.side.share(problem.used)));
  s.models = eachOf (@(b) struct ('model', problem.benchNames{b.bench}, ...
                                  'p', b.p, 'size', b.size), where.benches);
  s.params = cell2struct (num2cell (where.params(:)), problem.names(:), 1);
end

function level = levelOf (level, problem)
  if ~isempty (level)
    each = struct ('shift', num2cell (level.shift), 'shiftSd', num2cell (level.shiftSd));
    level.ofTarget = byTarget (namesOf (problem, 1:numel (each)), num2cell (each));
  end
end

% As byTarget takes them.
function list = namesOf (problem, targets)
  list = struct ('modelName', problem.benchNames(problem.bench(targets)), ...
                 'name', problem.targetNames(targets));
end

% What is not the noise of the measurement is that of the prediction: of the trials'
% packing, of the surrogates, and of a change what its reference leaves open.
function s = withNoise (T, sdMeasured)
  whole = abs (T.residual) / max (T.size, realmin);
  s = struct ('unabsorbed', 1 - T.absorbability, ...
              'deviation', sign (T.residual) * T.size, 'sdMeasured', sdMeasured, ...
              'sdPredicted', sqrt (max (whole^2 - sdMeasured^2, 0)));
end

% The strongest run of it with a result, in its unit; '': there is none.
function text = reachText (one, problem)
  text = '';
  e = problem.effects(strcmp ({problem.effects.name}, one.name));
  if isfinite (one.beyond)
    text = sprintf ('%.3g', one.beyond);
    if isfield (e, 'label')
      text = amountOf (e, e, one.beyond);
    end
  end
end

function s = whichOf (diagnosis)
  w = diagnosis.which;
  untested = diagnosis.screen.untested;
  hasFailed = [untested.runs] > 0;
  s = mergeFields (struct ('p', w.gateP), w, ...
                   {'verdict', 'reason', 'guard', 'effects', 'class', 'decides', ...
                    'together', 'sameKind', 'lookAlike', 'partners', 'likely', ...
                    'posterior', 'said', 'byItself', 'oneOf', 'groups', 'siblings'});
  s.probability = rmfield (w.posterior, {'null', 'unlisted'});
  s.cannotSee = [w.cannotSee, {untested(~hasFailed).name}];
  s.untested = eachOf (@(u) setfield (u, 'beyond', reachText (u, diagnosis.problem)), ...
                       untested(hasFailed));
  isOne = arrayfun (@(e) givenField (e, 'oneSided', false), diagnosis.problem.effects);
  s.oneSided = {diagnosis.problem.effects(isOne).name};
  s.cause = num2cell (w.cause);
  strengths = eachOf (@(k) strengthOf (w.strength(k), diagnosis.screen.smallest(k), ...
                                       diagnosis.problem), 1:numel (w.strength));
  s.strength = cell2struct (strengths, fieldsOf ({w.strength.name}), 2);
end

% What to do, as a program reads it: which parts are commands is for the page.
function todo = asText (todo)
  if ~isempty (todo)
    todo.text = [todo.parts.text];
    todo = rmfield (todo, 'parts');
  end
end

% What cannot be seen, or has no runs where it would fit, has no interval: its
% runs say nothing of its strength.
function s = strengthOf (strength, smallest, problem)
  isSeen = isfinite (smallest) && ~strcmp (strength.says, 'nothing');
  strength.interval90(~isSeen) = NaN;
  strength.values(2:3, ~isSeen(ones (1, columns (strength.values)))) = NaN;
  s = mergeFields (struct ('smallestSeen', smallest, 'seen', isSeen, 'label', ...
                           strength.name, 'unit', '', 'saysName', true, 'text', '', ...
                           'amount', '', 'seenFrom', '', 'atEnd', '', 'kind', '', ...
                           'inUnit', []), strength, ...
                   {'value', 'interval90', 'says'});
  s.variables = cell2struct (num2cell (strength.values', 2), strength.variables(:), 1);
  e = problem.effects(strcmp ({problem.effects.name}, strength.name));
  if isfield (e, 'label')
    s = mergeFields (s, e, {'label', 'unit'});
    s.saysName = givenField (e, 'saysName', false);
    s.kind = causeKind (e);
  end
end

% Strengths in their units.
function out = withAmounts (out, diagnosis)
  for strength = diagnosis.which.strength
    name = fieldsOf (strength.name);
    s = out.which.strength.(name);
    e = diagnosis.problem.effects(strcmp ({diagnosis.problem.effects.name}, strength.name));
    if columns (strength.values) == 1
      isLeast = strcmp (strength.says, 'least');
      isEnd = any (abs (strength.interval90 - farEnd (strength)) < 1e-6);
      [s.text, s.amount] = effectText (s.label, s.unit, cell2mat (struct2cell (s.variables)), ...
                                       isEnd && ~isLeast);
      if isLeast
        s.text = sentence ('strength.least', struct ('amount', s.text));
        s.amount = sentence ('strength.least', struct ('amount', s.amount));
      end
      s.seenFrom = seenFrom (e, s, s.smallestSeen);
      own = s.variables.(strength.variables{1});
      s.inUnit = struct ('value', own(1), 'interval90', own(2:3), 'smallestSeen', ...
                         valueOf (e, s.smallestSeen));
    end
    s.atEnd = atEnd (e, s, strength);
    out.which.strength.(name) = s;
  end
end

% The end of its range, where it stands there and would go on: in its unit. Its interval
% reaches the end, and it is near it or its density rises towards it.
function text = atEnd (e, s, strength)
  text = '';
  far = farEnd (strength);
  share = strength.value / far;
  isPiled = share >= 0.75 && share >= mean (strength.interval90) / far;
  if isempty (e) || ~(share >= 0.9 || isPiled) || ...
     ~any (abs (strength.interval90 - far) < 1e-6)
    return
  end
  text = amountOf (e, s, far);
end

function far = farEnd (strength)
  far = strength.range(1 + (strength.value > 0));
end

% The strength in its unit that would be seen in 8 of 10 cases (screenEffects).
function text = seenFrom (e, s, smallest)
  text = '';
  if isempty (e) || ~isfinite (smallest)
    return
  end
  text = sentence ('strength.seen', struct ('amount', amountOf (e, s, smallest)));
end

% A strength in words, as SAID (label, unit) has it.
function text = amountOf (e, said, phi)
  [~, text] = effectText (said.label, said.unit, [valueOf(e, phi), NaN, NaN]);
end

% Of its first variable, in its unit.
function value = valueOf (e, phi)
  value = NaN;
  if ~isempty (e) && isfinite (phi)
    value = e.strongest * phi;
    if ~e.laboratory
      value = valuesOfStrength (e, phi)(1);
    end
  end
end

function s = howFarOf (cure, problem, Case)
  if isempty (cure)
    s = struct ('effect', '', 'placebos', {{}}, 'targets', {{}});
    return
  end
  share = {'before', 'after', 'floor', 'closure', 'interval90', 'removable'};
  s = mergeFields (struct (), cure, [share, {'effect', 'verifiedByDEM'}]);
  if isstruct (cure.heldOut)
    s.heldOut = mergeFields (struct (), cure.heldOut, share);
  end
  s.placebos = eachOf (@(p) mergeFields (struct (), p, {'effect', 'closure', 'heldOut', ...
                                                        'logRatio', 'against'}), ...
                       cure.placebos);
  s.targets = eachOf (@(T) targetOf (T, problem, Case), cure.targets);
  names = strsplit (cure.effect, ' + ');
  s.strength = cell2struct (num2cell (cure.phi(:)), names(:), 1);
  s.values = struct ();
  for k = 1:numel (names)
    e = problem.effects(strcmp ({problem.effects.name}, names{k}));
    E = valuesOfStrength (e, cure.phi(k));
    s.values = mergeFields (s.values, cell2struct (num2cell (E(:)), ...
                                                   e.variables(1:numel (E))(:), 1));
  end
  s.params = cell2struct (num2cell (cure.params, 1)', problem.names(:), 1);
end

% What the user allows is NaN for a target that is not of the case.
function s = targetOf (T, problem, Case)
  t = T.target;
  roles = {'calibrate', 'holdout'};
  s = struct ('model', problem.benchNames{problem.bench(t)}, ...
              'name', problem.targetNames{t}, ...
              'role', roles{1 + ismember(t, problem.heldOut)}, ...
              'measured', problem.value(t), 'allowed', NaN);
  s = mergeFields (s, T, {'before', 'after', 'sdBefore', 'sd'});
  ofCase = targetAt (givenField (Case, 'targets', []), s);
  if ~isempty (ofCase)
    s.allowed = halfWidth (Case.targets(ofCase));
  end
end

function s = changeOf (diagnosis, Case)
  s = [];
  reference = diagnosis.problem.reference;
  if isempty (reference)
    return
  end
  isLead = numel (diagnosis.others.conditions) == numel (Case.conditions);
  s = struct ('condition', reference.condition, ...
              'folder', merge (isLead, 'gap', ['gap/', reference.condition]), ...
              'lack', diagnosis.change.size, 'targets', {{}}, ...
              'conditions', {forPrograms(diagnosis.others.conditions)}, ...
              'order', {num2cell(diagnosis.others.order)});
  s.origin = givenField (Case, 'origin', '');
  s.canChange = cell2struct ([changeWords(Case.effects), ...
                              repmat({'no'}, 1, numel (Case.unchanged))], ...
                             [{Case.effects.name}, Case.unchanged], 2);
  sd = diagnosis.change.sd;
  list = diagnosedTargets (diagnosis);
  info = targetInfo (Case);
  for T = list(~strcmp ({list.role}, 'holdout'))
    k = diagnosis.problem.kept(T.target);     % less the tests that are left out
    change = mergeFields (struct ('reference', reference.value(T.target), 'foretold', ...
                                  T.predicted, 'modelled', NaN, 'sd', sd(T.target), ...
                                  'simulated', diagnosis.change.simulated(T.target), ...
                                  'seenFrom', diagnosis.change.seen(T.target), ...
                                  'allowed', halfWidth (Case.targets(k)), ...
                                  'followed', ~strcmp (T.role, 'aside')), ...
                          T, {'model', 'name', 'measured', 'z'});
    change = mergeFields (change, info(k), {'kind', 'series', 'unit'});
    change.shown = Case.targets(k).shown;
    if isempty (change.shown.unit)
      change.shown.unit = info(k).unit;
    end
    if ~isempty (diagnosis.howFar) && change.followed
      at = [diagnosis.howFar.targets.target] == T.target;
      change.modelled = diagnosis.howFar.targets(at).after;
    end
    s.targets{end + 1} = change;
  end
  c = strcmp (Case.conditions, reference.condition);
  isOpen = arrayfun (@(T) isfinite (T.value) && ~isfinite (T.changed(c).value), ...
                     Case.targets);
  s.notMeasured = eachOf (@(T) struct ('model', T.modelName, 'name', T.name), ...
                          Case.targets(isOpen));
end

function writeHeadOf (gap, Case)
  far = gap.howFar;
  params = cellfun (@(name) far.params.(name)(2), Case.names);
  v = assignParams (Case.modelVars, params, Case.names);
  for f = givenField (Case, 'fixed', [])   % those that follow from the others
    v.(f.name) = f.at(1) + params(:)' * f.at(2:end)';
  end
  condition = char (jsonAt (gap, {'reference', 'condition'}));
  text = sprintf ("# %sparameters fitted together with %s (gap/gap.json)\n", ...
                  [condition, repmat(': ', 1, ~isempty (condition))], far.effect);
  writeAtomic (fullfile (Case.folder, 'gap', 'calibrated.head'), ...
               [text, headLines(mergeFields (v, far.values))]);
end

%!test
%! % a planted cause: it has the print of the gap, another one has not
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], [0, 0, 0.6, 0, 0]);
%! d = diagnoseMatrices (given, data, struct ('bootstrap', 49, ...
%!                                            'twins', 60));
%! P = d.fingerprint;
%! far = @(name) norm (P.effects(strcmp (d.screen.names, name), :) - ...
%!                     P.measured) / norm (P.measured);
%! assert (far ('spread') < 0.3);
%! assert (far ('size') > 0.5);
%! % the files of its diagnosis
%! Case = readyCase ();
%! [Case.modelVars, Case.names] = deal (struct ('c', 3), d.problem.names);
%! v = writeGapJson (d, Case);
%! read = @(name) fullfile (Case.folder, 'gap', name);
%! gap = jsondecode (fileread (read ('gap.json')));
%! assert (gap.verdict.word, v.word);
%! assert ([gap.where.targets.measured]', d.problem.value(d.problem.used)(:), 1e-9);
%! assert (gap.thresholds.level, 0.05);
%! assert (! isempty (regexp (gap.which.strength.spread.seenFrom, ' or more$')));
%! own = gap.which.strength.spread;
%! assert ([own.inUnit.value; own.inUnit.interval90], own.variables.spread, 1e-12);
%! assert (own.inUnit.smallestSeen / own.inUnit.value, own.smallestSeen / own.value, 0.3);
%! P = gap.fingerprint;
%! bench = fieldnames (P.ofTarget){1};
%! assert (P.ofTarget.(bench).(P.targets{1}).measured, P.measured(1));
%! assert (P.ofTarget.(bench).(P.targets{1}).effects.size, P.effects.size(1));
%! assert (gap.howFar.effect, 'spread');
%! head = headDefaults (read ('calibrated.head'));
%! assert (head.c, 3);
%! assert (head.spread, gap.howFar.values.spread, 1e-9);
%! assert (head.(Case.names{1}), gap.howFar.params.(Case.names{1})(2), 1e-9);
%! assert ([gap.where.targets.z]', d.where.t(:), 1e-9);
%! % at the end of its range: near it, or rising towards it; not in the middle
%! for row = {0.95, 0.3, true; 0.88, 0.67, true; 0.8, 0.65, false; 0.7, 0.4, false}'
%!   k = strcmp ({d.which.strength.name}, 'spread');
%!   far = d.which.strength(k).range(2);
%!   [d.which.strength(k).value, d.which.strength(k).interval90] = deal (row{1} * far, ...
%!                                                                       [row{2}, 1] * far);
%!   writeGapJson (d, Case);
%!   said = readJsonFile (read ('gap.json')).which.strength.spread.atEnd;
%!   assert (~isempty (said) == row{3}, sprintf ('%g', row{1}));
%! end
%!test
%! % a change from a reference: what is no result of a sentence is there before any
%! % is made, and the code of the verdict stands beside the condition
%! [given, data, means] = smallGapLab ();
%! given.value = means ([0.4, 0.6], zeros (1, 5));
%! given.reference = struct ('value', given.value, 'sd', given.sd, 'trials', Inf (1, 12), ...
%!                           'scatter', false (1, 12), 'perCondition', false (1, 2), ...
%!                           'condition', 'a');
%! d = diagnoseMatrices (given, data, struct ('bootstrap', 49, 'twins', 60));
%! Case = readyCase ();
%! Case.targets = Case.targets(ones (1, 12));
%! [Case.targets.changed] = deal (struct ('value', {1, 1}, 'sd', 0.1));
%! Case.targets(2).changed(1).value = NaN;
%! [Case.modelVars, Case.names] = deal (struct ('c', 3), d.problem.names);
%! [Case.conditions, Case.unchanged] = deal ({'a', 'b'}, {});
%! Case.effects = newEffect (struct ('name', 'cohesion', 'laboratory', true), 4);
%! [d.which.verdict, d.which.effects] = deal ('named', {'spread'});
%! d.problem.reference.condition = 'b';
%! d.others = compareConditions (d, []);
%! [~, others] = writeGapJson (d, Case);
%! assert ({others.code, others.kind}, {'faint', 'cannot tell'});  % as nothing differs
%! d.which.verdict = 'no gap';
%! d.problem.reference.condition = 'a';
%! d.others = compareConditions (d, others);
%! [~, others] = writeGapJson (d, Case);
%! file = fullfile (Case.folder, 'gap', 'gap.json');
%! gap = readJsonFile (file);
%! assert (cellfun (@(one) one.code, jsonList (gap, {'reference', 'conditions'}), ...
%!                  'UniformOutput', false), {others.code});
%! assert (gap.reference.notMeasured.name, Case.targets(2).name);
%! one = jsonList (gap, {'reference', 'conditions'}){2};
%! assert ([one.ofEffect.spread.probability, one.ofEffect.spread.value], ...
%!         [one.probability, one.strength]);
%! d.which.verdict = 'named';
%! d.which.strength = d.which.strength(1);         % of the named one no sentence is made
%! delete (file);
%! fail ('writeGapJson (d, Case)');
%! assert (readJsonFile (file).which.effects, {'spread'});

% SPDX-License-Identifier: GPL-3.0-only
