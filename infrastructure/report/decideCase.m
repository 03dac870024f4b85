% DECIDECASE  What a calibration and its diagnosis mean: decided here alone.
%
% CALL: V = decideCase (C, GAP)
% CALL: V = decideCase (C, GAP, ISBEGUN)
%
%   C    decoded results/calibration.json, [] where there is none
%   GAP  decoded gap/gap.json, [] where there is none
%   ISBEGUN  logical (false): without C, whether anything was run
%   V    scalar struct, texts without HTML:
%     word      the verdict in a few words;  class 'good', 'bad' or 'open'
%     sentence  why, one sentence
%     gap       what the diagnosis adds, one sentence; '': none was made
%     usable    logical: the calibrated set may be used
%     usableFor, notFor  1 x n cells of texts
%     action    what to do now, one sentence
%     numbers   1 x n struct label, text: the largest miss, the targets that
%               are met, the effect or the chance, with units
%     met, of   targets that are met, all that are calibrated (a curve is one)
%     misses    1 x n struct of the calibrated targets and the held-out ones:
%               model, name, unit, measured, simulated, miss, allowed, role,
%               met (1, 0; NaN: not measured), share (of what is allowed),
%               largest first
%     worst     name of the model with the largest miss; '': none
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
              'numbers', [], 'met', 0, 'of', 0, 'misses', [], ...
              'worst', '', 'cause', []);
  v.numbers = struct ('label', {}, 'text', {});
  if nargin > 2 && isBegun
    v.word = 'Not finished';
    v.sentence = ['The calibration is under way, or it was broken off: ', ...
                  'what is shown is what its files hold.'];
    v.action = 'Started again, it goes on where it stopped: decalioc run.';
  end
  v.misses = listMisses (c, gap);
  if ~isempty (v.misses)
    v.worst = v.misses(1).model;
  end
  if ~isempty (c)
    v = ofCalibration (v, c);
  end
  if ~isempty (gap)
    v.cause = decideGap (gap);
    v = withGap (v, c, v.cause);
  end
  v.numbers = keyNumbers (v, c);
end

function v = ofCalibration (v, c)
  used = v.misses(strcmp ({v.misses.role}, 'calibrate'));
  held = v.misses(strcmp ({v.misses.role}, 'holdout'));
  v.met = sum ([used.met] == 1);
  v.of = numel (used);
  v.usable = isequal (c.converged, true);
  v.sentence = sentenceOf (c.reason);
  benches = strjoin (unique ({used.model}, 'stable'), ', ');
  if v.usable
    v.word = 'Calibrated';
    v.class = 'good';
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
    v.word = 'Not calibrated';
    v.class = 'bad';
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

function text = sentenceOf (reason)
  text = [upper(reason(1)), reason(2:end), '.'];
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
  elseif strcmp (limit, 'maxNewRuns')
    text = ['Raise Input.maxNewRuns and start decalioc run again.', ...
            orWiden(c)];
  else
    text = ['Raise optim.maxFunEvals and start decalioc run again.', ...
            orWiden(c)];
  end
end

function text = orWiden (c)
  text = '';
  limits = namesIn (c, 'atLimit');
  if ~isempty (limits)
    text = sprintf (' Or widen the limits of %s, if the material allows.', ...
                    strjoin (worded (c, limits), ', '));
  end
end

function yes = isImported (c)
  models = jsonAt (c, {'input', 'models'});
  keys = arrayfun (@(k) isempty (jsonAt (models, {k, 'key'})), ...
                   1:numel (models));
  yes = ~isempty (keys) && all (keys);
end

function texts = looseOnes (c)
  texts = {};
  loose = worded (c, namesIn (c, 'notIdentified'));
  if ~isempty (loose)
    words = {'matters', 'matter'};
    texts = {sprintf(['flows in which %s %s: these targets leave it open, ' ...
                      'other values fit as well'], strjoin (loose, ', '), ...
                     words{1 + (numel (loose) > 1)})};
  end
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
  known = jsonAt (c, {'known'});
  if ~isstruct (known)
    return
  end
  for name = fieldnames (known)'
    own = known.(name{1});
    value = c.params.(name{1});
    off = abs (value - own.mean) / own.sd;
    if off > 3
      texts{end + 1} = sprintf (['flows in which %s matters: it was ' ...
                                 'measured as %.4g +- %.2g, and the set ' ...
                                 'has %.4g'], worded (c, name){1}, ...
                                own.mean, own.sd, value);
    end
  end
end

function v = withGap (v, c, cause)
  v.gap = cause.sentence;
  if isempty (c)
    v.word = cause.word;
    v.class = cause.class;
    v.sentence = cause.sentence;
    v.gap = '';
    v.notFor = {'anything yet: no calibration was made'};
    v.action = cause.action;
    if isempty (v.action)
      v.action = 'Calibrate the model: decalioc run.';
    end
    return
  end
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
%! % single sentences that had been wrong
%! list = verdictCase ();
%! of = @(name) list(strcmp ({list.name}, name));
%! decide = @(s) decideCase (jsondecode (jsonencode (s.c)), ...
%!                           jsondecode (jsonencode (s.gap)));
%! v = decide (of ('Sluice: missed, blind'));
%! assert (v.word, 'Not calibrated');
%! assert (! isempty (strfind (v.gap, ...
%!         'cannot tell whether one of these is there: cohesion, drag')));
%! assert ([v.met, v.of], [2, 3]);
%! v = decide (of ('a known value deviates'));
%! assert (! isempty (strfind (v.notFor{1}, 'measured as 1 +- 0.1')));
%! v = decide (of ('imported runs alone'));
%! assert (! isempty (strfind (v.action, 'runs.csv')));
%! v = decide (of ('every run fails'));
%! assert (! isempty (strfind (v.action, 'why runs fail')));
%! v = decide (of ('a curve is missed'));
%! assert ([v.met, v.of], [1, 2]);
%! v = decide (of ('conflict, never run'));
%! assert (v.sentence, 'No set of the box meets: sum.');
%! assert (! isempty (strfind (v.action, 'decalioc diagnose')));
