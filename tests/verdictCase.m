% VERDICTCASE  Stored results of many kinds, to see what is said of each.
%
% CALL: LIST = verdictCase ()
% CALL: verdictCase (FOLDER, SITUATION)
%
%   LIST       1 x n struct: name (text), c (as calibration.json, [] none), gap
%              (as gap.json, [] none)
%   FOLDER     case folder of standInCase: the files of SITUATION (one of LIST)
%              are written there
%
% See also: verdicts.tst, decideCase

function list = verdictCase (folder, situation)
  if nargin > 0
    put (fullfile (folder, 'results'), 'calibration.json', situation.c);
    put (fullfile (folder, 'gap'), 'gap.json', situation.gap);
    return
  end
  list = [ofCalibration(), withGap()];
end

function put (folder, name, content)
  [~, ~] = mkdir (folder);
  file = fullfile (folder, name);
  if isempty (content)
    [~, ~] = unlink (file);
  else
    writeAtomic (file, jsonencode (content));
  end
end

function list = ofCalibration ()
  met = result (true, [0, 0, 0]);
  off = result (false, [0.2, 0, 0]);
  near = result (false, [0, 0, 0]);
  list = at ('met', met, []);
  open = setfield (met, 'notIdentified', {{'b'}});
  list(end + 1) = at ('met, one parameter open', open, []);
  list(end + 1) = at ('met, held out inside', held (met, true), []);
  list(end + 1) = at ('met, held out outside', held (met, false), []);
  open = held (met, false);
  [open.holdout.interval90, open.holdout.inside] = deal ([0.8, 9], true);
  open.holdout.leftOpen = true;
  list(end + 1) = at ('met, held out left open', open, []);
  known = met;
  known.known.a = struct ('mean', 1, 'sd', 0.1);
  list(end + 1) = at ('a known value deviates', known, []);
  for limit = {'maxFunEvals', 'maxNewRuns', 'maxIter', 'unsettled'}
    list(end + 1) = at (limit{1}, ended (off, limit{1}, 'outside', 2), []);
  end
  list(end + 1) = at ('conflict, never run', ...
                      conflict (setfield (off, 'runs', 0)), []);
  list(end + 1) = at ('conflict', conflict (off), []);
  list(end + 1) = at ('conflict at a limit', ...
                      setfield (conflict (off), 'atLimit', {{'a'}}), []);
  failing = ended (off, 'maxIter', 'allFailed', 0);
  list(end + 1) = at ('every run fails', failing, []);
  alone = ended (near, 'maxNewRuns', 'notRun', 0);
  list(end + 1) = at ('surrogates alone', alone, []);
  alone.input.models = struct ('name', {'First', 'Second'}, 'key', '');
  list(end + 1) = at ('imported runs alone', alone, []);
  list(end + 1) = at ('too few replicates', few (near), []);
  scatter = ended (setfield (near, 'probability', 0.7), 'maxFunEvals', ...
                   'unsure', 2);
  list(end + 1) = at ('scatter', scatter, []);
  curve = off;
  [curve.targets(1:2).curve] = deal ('w');
  list(end + 1) = at ('a curve is missed', curve, []);
  list = [list, notJudged(near, off)];
  list(end + 1) = at ('nothing', [], []);
end

% Runs that miss or have no result, though all runs together meet the targets; a miss that
% no further run mends.
function list = notJudged (near, off)
  near.probability = 0.97;
  list = at ('open', ended (near, 'maxFunEvals', 'open', 2, struct ('names', {{'sum'}})), []);
  [list.c.targets.state] = deal ('open', 'met', 'met');
  none = struct ('none', 4, 'resulting', 4);
  list(end + 1) = at ('no result', ended (near, 'maxFunEvals', 'noResult', 4, none), []);
  list(end).c.outcomes = none;
  numbers = struct ('names', {{'sum'}}, 'none', 5, 'resulting', 3, 'restMet', true);
  list(end + 1) = at ('unjudged', ended (near, '', 'unjudged', 2, numbers), []);
  [list(end).c.targets.state] = deal ('unjudged', 'met', 'met');
  [list(end).c.targets(1).result, list(end).c.targets(1).residual] = deal (NaN);
  list(end).c.targets(1).met = false;
  numbers = struct ('names', {{'sum'}});
  list(end + 1) = at ('beyond scatter', ended (off, 'maxFunEvals', 'beyondScatter', 30, ...
                                               numbers), []);
end

function list = withGap ()
  met = result (true, [0, 0, 0]);
  off = ended (result (false, [0.2, 0, 0]), 'maxFunEvals', 'outside', 2);
  near = few (result (false, [0, 0, 0]));
  none = gapOf ('no gap', {}, 'gate');
  beyond = none;
  beyond.where.targets(3).z = 6.2;
  beyond.where.targets(3).p = 7e-10;
  blind = setfield (none, 'which', 'cannotSee', {'cohesion', 'drag'});
  named = gapOf ('named', {'cohesion'}, '');
  like = setfield (named, 'which', 'lookAlike', true);
  several = gapOf ('group', {'cohesion', 'drag'}, 'group');
  alike = gapOf ('group', {'cohesion'}, 'look-alike');
  pair = setfield (several, 'which', 'together', true);
  unlisted = gapOf ('none of the listed', {}, '');
  lost = struct ('name', 'drag', 'runs', 4, 'why', 'exit status 1');
  failing = setfield (unlisted, 'which', 'untested', lost);
  silent = setfield (none, 'which', 'untested', setfield (lost, 'why', ''));
  open = gapOf ('undecided', {}, 'integral');
  faint = open;
  faint.where.p = 0.19;
  faint.which.likely = {'cohesion', 'drag'};
  faint.which.cannotSee = {'cohesion', 'drag'};
  [faint.where.targets.p] = deal (0.5);
  poor = gapOf ('surrogate', {}, 'surrogate');
  poor.which.reason = 'the surrogates contradict their own runs';
  odd = named;
  odd.howFar.heldOut.closure = NaN;
  odd.howFar.closure = 1.21;
  odd.where.targets(3).p = 7e-10;
  odd.howFar.placebos = struct ('effect', 'drag', 'closure', {0.98, NaN});
  tight = named;
  [tight.howFar.closure, tight.howFar.removable] = deal (NaN, true);
  tells = several;
  tells.next = struct ('test', 'measure First once more', 'gain', 0.9);
  kinds = {'met, no gap', met, none; 'met, blind', met, blind; ...
           'met, held out tells', met, beyond; ...
           'missed, held out tells', off, beyond; ...
           'met, named', met, named; 'met, several', met, several; ...
           'missed, named or its like', off, like; ...
           'met, too few runs', met, poor; 'missed, no gap', off, none; ...
           'Sluice: missed, blind', off, blind; ...
           'near, blind', near, blind; ...
           'conflict, no gap', conflict(off), none; ...
           'conflict, blind', conflict(off), blind; ...
           'missed, named', off, named; 'missed, look-alike', off, alike; ...
           'missed, several', off, several; 'missed, pair', off, pair; ...
           'missed, a test tells', off, tells; ...
           'missed, none listed', off, unlisted; ...
           'missed, untested', off, failing; 'met, untested', met, silent; ...
           'missed, undecided', off, open; 'missed, surrogate', off, poor; ...
           'missed, faint and blind', off, faint; ...
           'near, faint and blind', near, faint; ...
           'missed, held out far off', off, odd; ...
           'missed, as many unknowns as targets', off, tight; ...
           'gap alone, none', [], none; 'gap alone, blind', [], blind; ...
           'gap alone, named', [], named};
  list = struct ('name', kinds(:, 1)', 'c', kinds(:, 2)', ...
                 'gap', kinds(:, 3)');
end

function s = at (name, c, gap)
  s = struct ('name', name, 'c', c, 'gap', gap);
end

function c = result (converged, residual)
  c = struct ('params', struct ('a', 4, 'b', 3), ...
              'interval90', struct ('a', [3.9, 4.1], 'b', [2.9, 3.1]), ...
              'limits', struct ('a', [0, 10], 'b', [0, 10]));
  names = {'sum', 'product', 'difference'};
  models = {'First', 'First', 'Second'};
  value = [7, 12, 1];
  for t = 1:3
    z = value(t) * (1 + residual(t));
    c.targets(t) = struct ('model', models{t}, 'name', names{t}, ...
                           'role', 'calibrate', 'target', value(t), ...
                           'sd', 0.1, 'tol', 0.02, 'unit', 'N', ...
                           'result', z, 'residual', residual(t), ...
                           'noiseSd', 0.01, 'interval90', z + [-1, 1] / 100, ...
                           'allowed', 0.02 * value(t), ...
                           'met', abs (residual(t)) <= 0.02, 'curve', '');
  end
  c.converged = converged;
  [c.known, c.untested, c.conflict] = deal (struct (), [], {});
  [c.probability, c.coreSeconds] = deal (0.99 * converged, 60);
  c = ended (c, '', 'converged', 2);
  c.demRuns = struct ('plan', 8, 'infill', 2, 'verify', 4, 'failed', 0, ...
                      'reused', 0);
  [c.atLimit, c.notIdentified, c.unfixed, c.next, c.holdout, c.levels] = ...
    deal ({});
  c.warnings = {};
  c.sensitivity = struct ('a', [0.5, 0.5, 0.5], 'b', [0.5, 0.5, 0.5]);
  c.correlation = eye (2);
  c.surrogates = struct ('model', models, 'target', names, 'Q2', 0.9, ...
                         'noiseSd', 0.01);
  c.history = {};
  c.input.models = struct ('name', {'First', 'Second'}, 'cpu', 1, 'key', 'ab');
  c.input.digest = '';                  % does not say of which input
  c.date = '2026-11-23 12:00';
  c.version = '1';
end

function c = few (c)
  c = ended (c, 'maxFunEvals', 'fewRuns', 1);
end

function c = ended (c, limit, code, runs, numbers)
  [c.runs, c.limit] = deal (runs, limit);
  if nargin < 5
    numbers = struct ();
  end
  numbers.runs = runs;
  options = struct ('maxFunEvals', 40, 'maxIter', 3, 'replicates', 3);
  ending = newEnding (code, mergeFields (numbers, c, ...
                                         {'probability', 'conflict', ...
                                          'limit'}), options);
  [c.ending, c.reason] = deal (rmfield (ending, 'text'), ending.text);
end

function c = conflict (c)
  c.conflict = {'sum'};
  c = ended (c, 'maxFunEvals', 'conflict', c.runs);
end

function c = held (c, inside)
  c.targets(3).role = 'holdout';
  c.targets(3).met = [];
  value = 1 + 4 * ~inside;
  c.targets(3).target = value;
  c.holdout = struct ('name', 'difference', 'model', 'Second', 'target', value, 'result', 1, ...
                      'sd', 0.1, 'interval90', [0.8, 1.2], 'inside', inside);
end

function gap = gapOf (verdict, effects, guard)
  targets = struct ('model', {'First', 'First', 'Second'}, ...
                    'name', {'sum', 'product', 'difference'}, ...
                    'role', {'calibrate', 'calibrate', 'holdout'}, ...
                    'z', {3.5, 0.2, 6.2}, 'p', {0.01, 1, 0.5}, ...
                    'unabsorbed', 0.5, 'blind', false, 'size', {3, 0.2, 6});
  if strcmp (verdict, 'no gap')
    [targets.p] = deal (0.9);
    [targets.z] = deal (0.3, 0.2, 0.6);
    [targets.size] = deal (0.3, 0.2, 0.6);
  end
  gap.where = struct ('p', merge (strcmp (verdict, 'no gap'), 0.6, 0.001), ...
                      'targets', targets, 'models', ...
                      struct ('model', {'First', 'Second'}, 'p', {0.01, 1}, ...
                              'size', {3.5, 0.1}), ...
                      'params', struct ('a', 4, 'b', 3), 'atLimit', {{}});
  strength = struct ();
  for name = {'cohesion', 'drag'}
    own = struct ('value', 0.5, 'interval90', [0.3, 0.7], ...
                  'smallestSeen', 0.2, 'seen', true, 'label', name{1}, ...
                  'unit', 'J/m3', 'saysName', true);
    own.text = [name{1}, ' 41 kJ/m3 (31 to 58)'];
    strength.(name{1}) = own;
  end
  gap.thresholds = struct ('level', 0.05, 'adviseAt', 0.2);
  gap.which = struct ('verdict', verdict, 'reason', 'the odds are 1.7 to 1', ...
                      'p', 0.01, 'guard', guard, 'effects', {effects}, ...
                      'together', false, ...
                      'lookAlike', strcmp (guard, 'look-alike'), ...
                      'likely', {{'cohesion'}}, 'cannotSee', {{}}, ...
                      'groups', {{}}, 'siblings', {{}}, ...
                      'strength', strength, 'posterior', ...
                      struct ('null', 0.05, 'cohesion', 0.9, 'drag', 0.4, ...
                              'unlisted', 0.05));
  part = struct ('before', 0.231, 'after', 0.042, 'floor', 0.066, ...
                 'closure', 0.9, 'interval90', [0.8, 1.1]);
  far = part;
  far.effect = '';
  far.heldOut = part;
  far.verifiedByDEM = false;
  far.placebos = struct ('effect', 'tilt', 'closure', 0.2, 'heldOut', 0.1);
  far.params = struct ('a', [4, 4.2], 'b', [3, 3.1]);
  if ~isempty (effects)
    far.effect = effects{1};
  end
  gap.howFar = far;
  gap.next = struct ('test', 'measure First once more', 'gain', 0.04, ...
                     'cost', 1);
end

% SPDX-License-Identifier: GPL-3.0-only
