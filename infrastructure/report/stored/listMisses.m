% LISTMISSES  Every measured target beside what is simulated, the worst first.
%
% CALL: MISSES = listMisses (C, GAP)
%
%   C, GAP   see decideCase
%   MISSES   1 x n struct of the calibrated targets and the held-out ones:
%            model, name, label (what it is, in words), unit, given (the unit of
%            measured.csv, '': the same), measured,
%            simulated, miss, allowed (the user's tolerance), role, met (1, 0;
%            NaN: not measured), share (of what is allowed), z (measured less
%            simulated, over its noise: of the measurement, of one run and of the
%            expected mean), scatter (of one run), isStrict (the tolerance lies below
%            that: no single measurement can confirm it), state, mean, meanSd, runs, range
%            (1 x 2, of all runs; NaN: not known), points (of a curve: they are
%            one entry, its worst point; else 1); largest z first. Without a
%            calibration those of the diagnosis, with z alone

function misses = listMisses (c, gap)
  targets = jsonList (c, {'targets'});
  if isempty (c)
    targets = jsonList (gap, {'where', 'targets'});
  end
  misses = missOf (struct ('model', '', 'name', '', 'role', ''), [])([]);
  for k = 1:numel (targets)
    misses(k) = missOf (targets{k}, jsonAt (c, {'runs'}));
  end
  if isempty (misses)
    return
  end
  misses = foldCurves (judgeHeldOut (misses, c), c);
  size_ = abs ([misses.z]);
  size_(isnan (size_)) = [misses(isnan (size_)).share];
  size_(isnan (size_)) = -1;
  [~, order] = sortrows ([strcmp({misses.role}, 'unmeasured')', -size_']);
  misses = misses(order);
end

% Where N runs were made, met and missed are said of what they and all runs
% together agree on; the others are open.
function m = missOf (T, n)
  field = @(name, other) givenField (T, name, other);
  z = field ('deviation', field ('z', NaN));      % of a diagnosis
  m = struct ('model', T.model, 'name', T.name, 'label', field ('label', ''), ...
              'unit', field ('unit', ''), 'given', field ('given', ''), ...
              'measured', field ('target', NaN), ...
              'simulated', field ('estimate', field ('result', NaN)), ...
              'miss', NaN, 'allowed', field ('allowed', NaN), ...
              'role', T.role, 'met', NaN, 'share', abs (z) / 2, ...
              'z', z, 'scatter', field ('noiseSd', 0), ...
              'isStrict', false, ...
              'state', '', 'mean', field ('result', NaN), ...
              'meanSd', field ('resultSd', NaN), 'runs', max ([n, 0]), ...
              'range', field ('range', [NaN, NaN])(:)', 'points', 1);
  m.miss = m.simulated - m.measured;
  residual = field ('residual', NaN);
  m.state = field ('state', '');
  if strcmp (T.role, 'calibrate') && isfinite (residual)
    shares = [abs(m.miss(m.allowed > 0)) / m.allowed, abs(residual) / T.tol];
    m.share = shares(find (isfinite (shares), 1));
    m.met = double (T.met);
    m.met(isOpenMiss (m)) = NaN;
  end
  if strcmp (m.state, 'unjudged')
    [m.met, m.share, m.simulated, m.mean, m.miss] = deal (NaN);
    return
  end
  ofMean = diff (field ('interval90', [0, 0])(:)') / 3.29;
  noise = norm ([field('sd', 0), m.scatter, ofMean]);
  if isnan (m.z) && isfinite (noise) && noise > 0
    m.z = (m.measured - m.simulated) / noise;
  end
  m.isStrict = strcmp (T.role, 'calibrate') && m.allowed < m.scatter;
end

% Held out: inside where a measurement should lie, or nearer than what the user
% allows; open where it lies inside for other parameter values alone.
function misses = judgeHeldOut (misses, c)
  for held = jsonList (c, {'holdout'})
    h = held{1};
    at = find (strcmp ({misses.name}, h.name) & ...
               ~strcmp ({misses.role}, 'calibrate'), 1);
    if ~isempty (at) && isnumeric (h.interval90) && ~isempty (h.inside)
      m = misses(at);
      m.simulated = h.result;
      m.miss = h.result - m.measured;
      m.share = abs (m.miss) / m.allowed;
      m.met = double (h.inside || m.share <= 1);
      if m.share > 1 && isequal (givenField (h, 'leftOpen', false), true)
        m.met = NaN;
      end
      m.z = (m.measured - m.simulated) * 3.29 / diff (h.interval90);
      misses(at) = m;
    end
  end
end

% A fitted curve is its worst point, met by its root mean square.
function misses = foldCurves (misses, c)
  name = eachOf (@(t) char (jsonAt (c, {'targets', t, 'curve'})), 1:numel (misses));
  curve = strcat ({misses.model}, {': '}, name);
  isPoint = ~cellfun (@isempty, name) & strcmp ({misses.role}, 'calibrate');
  keep = ~ismember (curve, curve(isPoint));
  for one = unique (curve(isPoint))
    members = find (isPoint & strcmp (curve, one{1}));
    [~, worst] = max ([misses(members).share]);
    at = members(worst);
    misses(at).share = sqrt (mean ([misses(members).share].^2));
    misses(at).points = numel (members);
    misses(at).isStrict = all ([misses(members).isStrict]);
    misses(at).name = name{at};
    keep(at) = true;
  end
  misses = misses(keep);
end

%!test
%! % the largest first; a held-out target by where a measurement should lie
%! decoded = @(x) jsondecode (jsonencode (x));
%! list = verdictCase ();
%! of = @(name) decoded (list(strcmp ({list.name}, name)));
%! s = of ('met, held out outside');
%! m = listMisses (s.c, []);
%! assert ({m.name}, {'difference', 'sum', 'product'});
%! assert ([m.met], [0, 1, 1]);
%! assert ([m(1).miss, m(1).allowed, m(1).share], [-4, 0.02, 200], 1e-12);
%! assert (m(1).z, 4 * 3.29 / 0.4, 1e-9);
%! s = of ('a curve is missed');
%! m = listMisses (s.c, []);
%! assert ({m.name}, {'w', 'difference'});
%! assert (m(1).share, sqrt (10^2 / 2), 1e-9);
%! % a diagnosis alone knows z
%! s = of ('gap alone, named');
%! assert ([listMisses([], s.gap).share], [3.1, 1.75, 0.1], 1e-12);
%! % a tolerance below the scatter of a run; one tolerance, the user's
%! s = of ('met');
%! s.c.targets(2).noiseSd = 0.3;
%! m = listMisses (s.c, []);
%! assert ([m.isStrict], strcmp ({m.name}, 'product'));
%! s = of ('met, held out inside');
%! s.c.holdout.inside = false;
%! s.c.holdout.result = 1.01;
%! m = listMisses (s.c, []);
%! assert (m(strcmp ({m.name}, 'difference')).met, 1);
%! s = of ('met, held out left open');
%! m = listMisses (s.c, []);
%! assert ([m.met], [NaN, 1, 1]);

% SPDX-License-Identifier: GPL-3.0-only
