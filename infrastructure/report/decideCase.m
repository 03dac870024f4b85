% DECIDECASE  What a calibration and its diagnosis mean: decided here alone.
%
% CALL: V = decideCase (C, GAP [, ISBEGUN])
%
%   C, GAP   decoded results/calibration.json, gap/gap.json; []: there is none
%   ISBEGUN  logical (false): without C, whether anything was run
%   V    scalar struct, texts without HTML:
%     word      the verdict in a few words;  class 'good', 'bad' or 'open'
%     sentence  why, one sentence
%     gap       what the diagnosis adds, one sentence; '': none was made
%     usable    logical: the calibrated set may be used;  usableFor, notFor
%               1 x n cells of texts;  action  what to do now, one sentence
%     numbers   1 x n struct label, text (with units)
%     met, of   targets that are met, all that are calibrated (a curve is one)
%     misses    see listMisses;  worst  name of the model of the largest, ''
%     cause     see decideGap; [] where no diagnosis was made
%
% Console, JSON, status and page show V; none of them decides again. A set is
% never called usable that is not converged, and a gap is never denied while
% a candidate could not be seen.

function v = decideCase (c, gap, isBegun)
  v = struct ('word', 'No result yet', 'class', 'open', 'sentence', ...
              'Nothing of this case has been run.', 'gap', '', ...
              'usable', false, 'usableFor', {{}}, 'notFor', {{}}, ...
              'action', 'Start decalioc run in the case folder.', ...
              'numbers', [], 'met', 0, 'of', 0, ...
              'misses', listMisses (c, gap), 'worst', '', 'cause', []);
  if nargin > 2 && isBegun
    v.word = 'Not finished';
    v.sentence = ['The calibration is under way, or it was broken off: ', ...
                  'what is shown is what its files hold.'];
    v.action = 'Started again, it goes on where it stopped: decalioc run.';
  end
  models = {v.misses.model, ''};
  v.worst = models{1};
  if ~isempty (c)
    v = ofCalibration (v, c);
  end
  if ~isempty (gap)
    v = withGap (v, c, decideGap (gap));
  end
  v.numbers = keyNumbers (v, c);
end

function numbers = keyNumbers (v, c)
  number = @(label, text) struct ('label', label, 'text', text);
  numbers = number ({}, {});
  if ~isempty (v.misses)
    numbers(end + 1) = number (missTexts (v.misses(1)){:});
  end
  if v.of > 0
    label = 'targets met';
    if isequal (jsonAt (c, {'runs'}), 0)
      label = 'targets met, on the surrogates alone';
    elseif ~v.usable && v.met == v.of
      label = 'targets within tolerance so far, not surely';
    end
    numbers(end + 1) = number (label, sprintf ('%d of %d', v.met, v.of));
  end
  chance = jsonAt (c, {'probability'});
  if ~isempty (v.cause) && ~isempty (v.cause.amount)
    numbers(end + 1) = v.cause.amount;
  elseif ~isempty (chance)
    texts = {sprintf('%.0f %%', 100 * chance), '> 99 %'};
    numbers(end + 1) = number ('chance that all targets are met', ...
                               texts{1 + (chance > 0.995)});
  end
end

function texts = missTexts (m)
  label = 'largest miss: ';
  if m.met == 1 || (isnan (m.met) && m.share < 1)
    label = 'largest deviation: ';
  end
  held = repmat (' (never fitted)', 1, strcmp (m.role, 'holdout'));
  text = ['simulated ', quantity(m.simulated, m.unit)];
  if isfinite (m.measured)
    allowed = quantity (m.measured, m.unit, ...
                        m.measured + m.allowed * [-1, 1]);
    text = [text, ', measured ', strrep(allowed, ' (', ' (allowed ')];
  elseif ~isfinite (m.simulated)
    text = sprintf ('%.1f times its noise', 2 * m.share);
  end
  texts = {[label, m.name, held], text};
end

function v = ofCalibration (v, c)
  used = v.misses(strcmp ({v.misses.role}, 'calibrate'));
  held = v.misses(strcmp ({v.misses.role}, 'holdout'));
  v.met = sum ([used.met] == 1);
  v.of = numel (used);
  v.usable = isequal (c.converged, true);
  v.sentence = [upper(c.reason(1)), c.reason(2:end), '.'];
  if v.usable
    [v.word, v.class] = deal ('Calibrated', 'good');
    benches = strjoin (unique ({used.model}, 'stable'), ', ');
    v.usableFor{end + 1} = ['flows like those that were measured (', ...
                            benches, '): all targets are met'];
    right = {held([held.met] == 1).name};
    if ~isempty (right)
      v.usableFor{end + 1} = ['what was never fitted and is predicted: ', ...
                              strjoin(right, ', ')];
    end
    v.action = ['Use the set: results/calibrated.head holds the lines for ', ...
                'a data.head.'];
  else
    [v.word, v.class] = deal ('Not calibrated', 'bad');
    v.notFor{end + 1} = notCalibrated (used, c);
    v.action = wayOn (c);
  end
  wrong = {held([held.met] == 0).name};
  if ~isempty (wrong)
    v.notFor{end + 1} = ['what was never fitted and is missed: ', ...
                         strjoin(wrong, ', ')];
    if v.usable
      v.class = 'open';
      v.action = askGap ();
    end
  end
  v.notFor = [v.notFor, looseOnes(c), knownOnes(c)];
end

function text = notCalibrated (used, c)
  missed = {used([used.met] == 0).name};
  if ~isempty (missed)
    text = ['anything that depends on what is missed: ', ...
            strjoin(missed, ', ')];
  elseif isequal (jsonAt (c, {'runs'}), 0)
    text = 'anything yet: the targets are met on the surrogates alone';
  else
    text = 'anything yet: the runs do not make sure that the targets are met';
  end
end

function text = askGap ()
  text = ['Ask what the model lacks: list candidates in loadEffects.m and ', ...
          'start decalioc diagnose.'];
end

% The one thing that can be done about a set that is not confirmed.
function text = wayOn (c)
  limit = jsonAt (c, {'limit'});
  if ~isempty (strfind (c.reason, 'every DEM run'))
    text = ['Look at why runs fail (Runs and failures; decalioc status), ', ...
            'mend the model, then start decalioc run again.'];
  elseif strncmp (c.reason, 'published method', 16)
    text = ['Leave out optim.method and start decalioc run again: a ', ...
            'robust calibration takes these runs and goes on.'];
  elseif strncmp (c.reason, 'no set of the box', 17) || ...
         strcmp (limit, 'maxIter')
    text = [askGap(), orWiden(c)];
  elseif isImported (c)
    text = ['Run this set with your DEM code, add the run to runs.csv and ', ...
            'start decalioc run again.'];
  else
    fields = {'optim.maxFunEvals', 'Input.maxNewRuns'};
    text = ['Raise ', fields{1 + strcmp(limit, 'maxNewRuns')}, ...
            ' and start decalioc run again.', orWiden(c)];
  end
end

function text = orWiden (c)
  text = '';
  limits = namesIn (c, 'atLimit');
  if ~isempty (limits)
    text = [' Or widen the limits of ', strjoin(worded (c, limits), ', '), ...
            ', if the material allows.'];
  end
end

function yes = isImported (c)
  models = jsonAt (c, {'input', 'models'});
  hasKey = arrayfun (@(k) ~isempty (jsonAt (models, {k, 'key'})), ...
                     1:numel (models));
  yes = ~isempty (models) && ~any (hasKey);
end

function texts = looseOnes (c)
  loose = worded (c, namesIn (c, 'notIdentified'));
  texts = {['flows in which ', strjoin(loose, ', '), ' matter', ...
            repmat('s', 1, isscalar (loose)), ': these targets leave it ', ...
            'open, other values fit as well']};
  texts = texts(~isempty (loose));
end

% 'friction between grains (coefFrictionPP)', where the words are known.
function names = worded (c, names)
  for k = 1:numel (names)
    label = jsonAt (c, {'labels', names{k}});
    if ischar (label) && ~isempty (label)
      names{k} = sprintf ('%s (%s)', regexprep (label, ' \([^)]*\)$', ''), ...
                          names{k});
    end
  end
end

% What was measured by itself and came out otherwise is named.
function texts = knownOnes (c)
  texts = {};
  for name = fieldnames (c.params)'
    measured = jsonAt (c, {'known', name{1}});
    value = c.params.(name{1});
    if ~isempty (measured) && abs (value - measured.mean) > 3 * measured.sd
      texts{end + 1} = sprintf (['flows in which %s matters: it was ' ...
                                 'measured as %.4g +- %.2g, and the set ' ...
                                 'has %.4g'], worded (c, name){1}, ...
                                measured.mean, measured.sd, value);
    end
  end
end

function v = withGap (v, c, cause)
  v.cause = cause;
  if isempty (c)
    v = mergeFields (v, cause, {'word', 'class', 'sentence', 'action'});
    v.notFor = {'anything yet: no calibration was made'};
    if isempty (v.action)
      v.action = 'Calibrate the model: decalioc run.';
    end
    return
  end
  v.gap = cause.sentence;
  isAsked = strncmp (v.action, askGap (), numel (askGap ()));
  if v.usable && ~strcmp (cause.kind, 'none')
    v.class = 'open';
    v.notFor = [v.notFor, cause.notFor];
    v.action = cause.action;
  elseif ~v.usable && strcmp (cause.kind, 'none') && isAsked
    v.action = cause.without;
  elseif ~v.usable && ~isempty (cause.action) && ...
         (isAsked || ~any (strcmp (cause.kind, {'no verdict', ...
                                                'cannot tell'})))
    v.action = cause.action;
  end
end

%!test
%! wanted = {'met', 'Calibrated', 'good', true; ...
%!           'met, held out outside', 'Calibrated', 'open', true; ...
%!           'too few replicates', 'Not calibrated', 'bad', false; ...
%!           'met, named', 'Calibrated', 'open', true; ...
%!           'gap alone, none', 'No gap seen', 'good', false};
%! coded = @(x) jsondecode (jsonencode (x));
%! list = verdictCase ();
%! for row = wanted'
%!   s = list(strcmp ({list.name}, row{1}));
%!   v = decideCase (coded (s.c), coded (s.gap));
%!   assert ({v.word, v.class, v.usable}, row(2:4)');
%! end
