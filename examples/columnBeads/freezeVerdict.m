% FREEZEVERDICT  Writes verdict.json and sealedCauses.csv from gap/.
%
% CALL: octave-cli freezeVerdict.m
%
% verdict.json: of series 2, 3 and 4 whether something has changed, the verdict,
% the probabilities of all candidates, the strengths, closure and placebos; of
% each two changed ones the probability that the cause is the same, and of each
% named effect, if it were that in both, where there is more of it. Same: the
% cause of each is one of the K candidates, with its probabilities p; were they
% the same in half of all cases, the odds are K sum (p of one x p of the other).
%
% sealedCauses.csv, what runPredictions.m is to run: the reference; of each changed
% series the effects of the verdict, and its two placebos. Columns: series,
% name, role, probability, strength (median, 5 %, 95 %; shares of the range).
%
% See also: diagnoseGap, runPredictions

1;

function one = verdictOf (gap, series)
  which = gap.which;
  effects = which.effects;
  if ischar (effects)
    effects = repmat ({effects}, 1, ~isempty (effects));
  end
  isGap = any (strcmp (which.verdict, ...
                       {'named', 'group', 'none of the listed'}));
  one = struct ('series', series, 'changed', isGap, 'p', which.p, ...
                'verdict', which.verdict, ...
                'effects', {effects}, ...
                'lookAlike', which.lookAlike, 'probability', ...
                which.posterior, 'strength', which.strength, ...
                'closure', gap.howFar.closure, ...
                'interval90', gap.howFar.interval90, ...
                'verifiedByDEM', gap.howFar.verifiedByDEM, ...
                'placebos', {gap.howFar.placebos}, ...
                'sentence', gap.verdict.cause.sentence);
end

function pair = samePair (a, b)
  names = setdiff (fieldnames (a.probability), {'null', 'unlisted'});
  p = cellfun (@(n) a.probability.(n), names);
  q = cellfun (@(n) b.probability.(n), names);
  odds = numel (names) * sum (p / sum (p) .* (q / sum (q)));
  pair = struct ('series', [a.series, b.series], ...
                 'sameCause', odds / (1 + odds), 'more', {{}});
  for name = union (a.effects, b.effects)
    if all (isfinite ([a.strength.(name{1}).interval90(:); ...
                       b.strength.(name{1}).interval90(:)]))
      pair.more{end + 1} = moreOf (name{1}, a, b);
    end
  end
end

% If both were NAME: in which there is more of it.
function side = moreOf (name, a, b)
  s = a.strength.(name);
  t = b.strength.(name);
  sd = norm ([diff(s.interval90), diff(t.interval90)] / 3.29);
  p = 0.5 * erfc (-(s.value - t.value) / max (sd, realmin) / sqrt (2));
  side = struct ('effect', name, 'series', a.series, 'probability', p);
  if p < 0.5
    side = struct ('effect', name, 'series', b.series, 'probability', 1 - p);
  end
end

function line = causeLine (v, name, role)
  field = matlab.lang.makeValidName (name);
  s = v.strength.(field);
  q = s.interval90;
  if isempty (q) || ~all (isfinite (q))
    q = [s.value, s.value];
  end
  line = sprintf ('%d,%s,%s,%.3f,%.3g,%.3g,%.3g', v.series, name, role, ...
                  v.probability.(field), s.value, q);
end

here = fileparts (mfilename ('fullpath'));
root = fileparts (fileparts (here));
addpath (fullfile (root, 'infrastructure'));
startToolbox (root);
places = {'', 'series3', 'series4'};
lines = {'series,name,role,probability,strength,lo90,hi90', ...
         '1,reference,reference,1,0,0,0'};
for k = 1:3
  gap = readJsonFile (fullfile (here, 'gap', places{k}, 'gap.json'));
  v(k) = verdictOf (gap, k + 1);
  if ~v(k).changed
    continue
  end
  for name = v(k).effects(:)'
    lines{end + 1} = causeLine (v(k), name{1}, 'cause');
  end
  for i = 1:numel (v(k).placebos)
    own = jsonAt (v(k).placebos, {i});
    lines{end + 1} = causeLine (v(k), own.effect, 'placebo');
  end
end
out = struct ('series', {num2cell(v)}, 'same', {{}});
changed = v([v.changed]);
for i = 1:numel (changed)
  for j = 1:i - 1
    out.same{end + 1} = samePair (changed(j), changed(i));
  end
end
writeAtomic (fullfile (here, 'verdict.json'), [jsonencode(out), "\n"]);
writeAtomic (fullfile (here, 'sealedCauses.csv'), sprintf ("%s\n", lines{:}));

% SPDX-License-Identifier: GPL-3.0-only
