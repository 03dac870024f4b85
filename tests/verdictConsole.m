% VERDICTCONSOLE  What calibration and diagnosis print of a stored situation.
%
% CALL: TEXT = verdictConsole (SITUATION, CASE)
%
%   SITUATION  one of verdictCase ()
%   CASE       newCase of standInCase
%   TEXT       all lines of reportCalibration and sayDiagnosis, as far as the
%              situation has a calibration and a diagnosis
%
% The structs of the computation are made again of what its files hold.
%
% See also: verdictCase, reportCalibration, sayDiagnosis

function text = verdictConsole (situation, Case)
  coded = @(x) jsondecode (jsonencode (x));
  c = coded (situation.c);
  gap = coded (situation.gap);
  v = decideCase (c, gap);
  say = @(line) printf ("%s\n", line);
  text = '';
  if ~isempty (c)
    [Case.targets.role] = c.targets.role;
    text = evalc ('reportCalibration (foundOf (c, v, Case), Case, say)');
  end
  if ~isempty (gap)
    text = [text, evalc('sayDiagnosis (diagnosisOf (gap, v), Case, say)')];
  end
end

function own = foundOf (c, v, Case)
  own = struct ('verdict', v, 'converged', c.converged, 'reason', c.reason);
  own.params = cellfun (@(n) c.params.(n), Case.names);
  rowsOf = @(field) cellfun (@(n) c.(field).(n)(:)', Case.names(:), ...
                             'UniformOutput', false);
  own.interval90 = vertcat (rowsOf ('interval90'){:})';
  own.sensitivity = vertcat (rowsOf ('sensitivity'){:});
  own.results = [c.targets.result];
  own.residual = [c.targets.residual]';
  own.noiseSd = [c.targets.noiseSd];
  own.met = abs (own.residual') <= [c.targets.tol];
  if isfield (c.targets, 'met')
    own.met = arrayfun (@(t) isequal (t.met, true), c.targets(:)');
  end
  words = {'missed', 'met'};
  own.state = words(1 + own.met);
  own.state(own.met ~= (abs (own.residual') <= [c.targets.tol])) = {'open'};
  if isfield (c.targets, 'state')
    own.state = {c.targets.state};
    own.met = strcmp (own.state, 'met');
  end
  own.estimate = own.results;
  for t = 1:numel (c.targets)
    both = [givenField(c.targets(t), 'estimate', []), own.results(t)];
    own.estimate(t) = both(1);
  end
  own.identifiability = struct ('text', {cellstr(c.unfixed)(1:0)}, ...
                                'next', []);
  for field = {'runs', 'correlation', 'demRuns', 'coreSeconds', 'holdout', ...
               'levels', 'warnings'}
    own.(field{1}) = c.(field{1});
  end
  own.untested = [];
  own.intervalNote = '';
end

function d = diagnosisOf (gap, v)
  targets = gap.where.targets;
  isHeld = strcmp ({targets.role}, 'holdout');
  models = {gap.where.models.model};
  d.verdict = v;
  [~, d.budget] = newEvaluate ([]);
  d.gapProblem = struct ('used', find (~isHeld), 'heldOut', find (isHeld), ...
                         'targetNames', {{targets.name}}, ...
                         'value', [7, 12, 1], 'benchNames', {models}, ...
                         'bench', [1, 1, 2], ...
                         'effects', struct ('name', {'cohesion', 'drag'}), ...
                         'reference', []);
  d.others.conditions = [];
  used = targets(~isHeld);
  d.where = struct ('p', gap.where.p, 'residual', 0.1 * [used.z], ...
                    't', [used.z], 'pTarget', [used.p], ...
                    'blind', [used.blind], 'out', {{}}, ...
                    'absorbability', 1 - [used.unabsorbed], ...
                    'size', [used.size]);
  held = targets(isHeld);
  d.where.held = struct ('z', [held.z], 'mean', 1 - 0.1 * [held.z], ...
                         'p', [held.p]);
  d.where.benches = struct ('bench', {1, 2}, 'p', {gap.where.models.p}, ...
                            'size', {gap.where.models.size});
  d.where.conflict.odd = [];
  d.where.side.atLimit = {};
  d = withCauses (d, gap.which);
  d.howFar = cureOf (gap.howFar, find (isHeld));
  d.next = gap.next;
end

function d = withCauses (d, which)
  names = {'cohesion', 'drag'};
  d.which = which;
  for field = {'effects', 'siblings', 'partners'}
    d.which.(field{1}) = namesIn (which, field{1});
  end
  d.which.strength = struct ('name', names, 'value', 0.5, ...
                             'interval90', [0.3, 0.7], 'values', [5; 3; 7], ...
                             'says', 'bound');
  d.screen = struct ('gain', [2, 1], 'smallest', [0.2, 0.4]);
  d.screen.smallest(ismember (names, namesIn (which, 'cannotSee'))) = Inf;
end

% With rivals that close more than all and nothing, and one hopelessly less
% likely.
function cure = cureOf (far, held)
  cure = [];
  if isempty (far.effect)
    return
  end
  cure = far;
  [cure.floorAfter, cure.gapP, cure.largestZ] = deal (0.05, 0.2, 1.5);
  cure.free = 1;
  if isfield (far, 'removable') && isempty (far.closure)
    [cure.floorAfter, cure.free, cure.closure] = deal (0, 0, NaN);
  end
  cure.targets = struct ('target', {1, held}, 'before', 1, 'after', 2, ...
                         'sd', 0.1);
  closures = {1.21, 0.001, NaN};
  logRatios = {log(5e22), -50, 1};
  cure.placebos = struct ('effect', 'tilt', 'closure', closures, ...
                          'expected', 0.3, 'difference', 0.2, ...
                          'difference90', [0.1, 0.3], ...
                          'logRatio', logRatios, ...
                          'against', {true, false, false}, ...
                          'verifiedByDEM', false);
end
