% LISTMISSES  Every measured target beside what is simulated, the worst first.
%
% CALL: MISSES = listMisses (C, GAP)
%
%   C, GAP   see decideCase
%   MISSES   1 x n struct of the calibrated targets and the held-out ones:
%            model, name, unit, measured, simulated, miss, allowed (the user's
%            tolerance), role, met (1, 0; NaN: not measured), share (of what is
%            allowed), z (over its noise: of the measurement, of one run and of
%            the expected mean), scatter (of one run), isStrict (the tolerance
%            lies below that: no single measurement can confirm it), state,
%            mean, meanSd, runs, points (of a curve: they are one entry, its
%            worst point; else 1); largest z first. Without a calibration those
%            of the diagnosis, with z alone

function misses = listMisses (c, gap)
  targets = jsonAt (c, {'targets'});
  if isempty (c)
    targets = jsonAt (gap, {'where', 'targets'});
  end
  misses = missOf (struct ('model', '', 'name', '', 'role', ''))([]);
  for t = 1:numel (targets)
    misses(t) = missOf (jsonAt (targets, {t}));
  end
  if ~isempty (c)
    misses = withRuns (misses, c);
    misses = judgeHeldOut (misses, c);
    misses = foldCurves (misses, c);
  end
  if ~isempty (misses)
    size_ = abs ([misses.z]);
    size_(isnan (size_)) = [misses(isnan (size_)).share];
    size_(isnan (size_)) = -1;
    [~, order] = sortrows ([strcmp({misses.role}, 'unmeasured')', -size_']);
    misses = misses(order);
  end
end

function m = missOf (T)
  field = @(name, other) fieldOf (T, name, other);
  m = struct ('model', T.model, 'name', T.name, 'unit', field ('unit', ''), ...
              'measured', field ('target', NaN), ...
              'simulated', field ('estimate', field ('result', NaN)), ...
              'miss', NaN, 'allowed', field ('allowed', NaN), ...
              'role', T.role, 'met', NaN, 'share', abs (field ('z', NaN)) / 2, ...
              'z', field ('z', NaN), 'scatter', field ('noiseSd', 0), ...
              'isStrict', false, ...
              'state', '', 'mean', field ('result', NaN), ...
              'meanSd', field ('resultSd', NaN), 'runs', 0, 'points', 1);
  m.miss = m.simulated - m.measured;
  residual = field ('residual', NaN);
  tol = field ('tol', NaN);
  if isnan (m.allowed) && isfinite (tol) && isfinite (m.measured)
    m.allowed = abs (m.measured) * tol;
  end
  if strcmp (T.role, 'calibrate') && isfinite (residual)
    m.met = double (abs (residual) <= tol);
    m.share = abs (residual) / tol;
    if isfinite (m.miss) && m.allowed > 0
      m.share = abs (m.miss) / m.allowed;
    end
    m.met = double (field ('met', m.met > 0));
    m.state = field ('state', '');
  end
  ofMean = diff (field ('interval90', [0, 0])(:)') / 3.29;
  noise = norm ([field('sd', 0), m.scatter, ofMean]);
  if isnan (m.z) && isfinite (noise) && noise > 0
    m.z = m.miss / noise;
  end
  m.isStrict = strcmp (T.role, 'calibrate') && m.allowed < m.scatter;
end

% Where runs were made, met and missed are said of what they and all runs
% together agree on; the others are open.
function misses = withRuns (misses, c)
  n = jsonAt (c, {'runs'});
  for k = 1:numel (misses) * ~isempty (n)
    misses(k).runs = n;
    if n > 0 && strcmp (misses(k).state, 'open')
      misses(k).met = NaN;
    end
  end
end

function value = fieldOf (T, name, other)
  value = other;
  if isfield (T, name) && ~isempty (T.(name))
    value = T.(name);
  end
end

% Held out: inside where a measurement should lie, or nearer than what the user
% allows.
function misses = judgeHeldOut (misses, c)
  held = jsonAt (c, {'holdout'});
  for k = 1:numel (held)
    h = jsonAt (held, {k});
    at = find (strcmp ({misses.name}, h.name) & ...
               ~strcmp ({misses.role}, 'calibrate'), 1);
    if ~isempty (at) && isnumeric (h.interval90) && ~isempty (h.inside)
      m = misses(at);
      m.simulated = h.result;
      m.miss = h.result - m.measured;
      m.share = abs (m.miss) / m.allowed;
      m.met = double (h.inside || m.share <= 1);
      m.z = m.miss * 3.29 / diff (h.interval90);
      misses(at) = m;
    end
  end
end

function misses = foldCurves (misses, c)
  curve = repmat ({''}, 1, numel (misses));
  for t = 1:numel (misses)
    name = jsonAt (c, {'targets', t, 'curve'});
    if ischar (name) && ~isempty (name)
      curve{t} = [misses(t).model, ': ', name];
    end
  end
  keep = cellfun (@isempty, curve);
  for name = unique (curve(~keep))
    members = find (strcmp (name{1}, curve) & ...
                    strcmp ({misses.role}, 'calibrate'));
    if isempty (members)
      keep(strcmp (name{1}, curve)) = true;
      continue
    end
    share = sqrt (mean ([misses(members).share].^2));
    [~, worst] = max ([misses(members).share]);
    at = members(worst);
    misses(at).share = share;
    misses(at).points = numel (members);
    misses(at).isStrict = all ([misses(members).isStrict]);
    misses(at).name = jsonAt (c, {'targets', at, 'curve'});
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
%! assert (m(1).z, -4 * 3.29 / 0.4, 1e-9);
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
