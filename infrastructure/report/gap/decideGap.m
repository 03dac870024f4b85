% DECIDEGAP  What a diagnosis means, in words and in units.
%
% CALL: CAUSE = decideGap (GAP)
%
%   GAP    decoded gap/gap.json
%   CAUSE  scalar struct, texts without HTML:
%     kind      'none', 'cannot tell', 'found', 'several', 'unlisted', 'open',
%               'no verdict'
%     word, sentence, class  as in decideCase
%     where     where the model misses, one sentence
%     closed    how much of it the cause takes away, one sentence; '': not tried
%     action    what to do now; '': the diagnosis asks for nothing
%     without   what to do about a set that is not calibrated although the
%               diagnosis asks for nothing
%     notFor    cell of texts: what a calibrated set is not to be used for
%     amount    struct label, text: the effect in its unit; []: none
%     cannotSee 1 x n cell, candidates that could not be seen

function cause = decideGap (gap)
  which = gap.which;
  effects = namesIn (which, 'effects');
  cause = struct ('kind', 'open', 'word', '', 'sentence', '', ...
                  'class', 'open', 'where', whereText (gap), ...
                  'closed', closedText (gap), 'action', '', 'without', '', ...
                  'notFor', {{}}, 'amount', [], ...
                  'cannotSee', {namesIn(which, 'cannotSee')});
  switch which.verdict
    case 'no gap'
      cause = noGap (cause, gap);
    case {'named', 'group'}
      if all (ismember (effects, cause.cannotSee))
        cause = stillOpen (cause, gap);
      else
        cause = found (cause, gap, effects);
      end
    case 'none of the listed'
      cause.kind = 'unlisted';
      cause.word = 'None of the listed causes';
      cause.class = 'bad';
      cause.sentence = ['Something is missing, and none of the listed ', ...
                        'causes explains it.'];
      cause.action = ['Add causes that act where the model misses to ', ...
                      'loadEffects.m and start decalioc diagnose again.'];
    case 'surrogate'
      cause.kind = 'no verdict';
      cause.word = 'No verdict on the gap: too few runs';
      cause.sentence = ['The runs do not allow a verdict on the gap: ', ...
                        which.reason, '.'];
      cause.action = 'Raise Input.maxNewRuns, start decalioc diagnose again.';
    otherwise
      cause = stillOpen (cause, gap);
  end
  if isempty (cause.notFor) && ~strcmp (cause.kind, 'none')
    cause.notFor = {['what the missing cause would change (', cause.word, ...
                     ')']};
  end
  if ~isempty (jsonAt (gap, {'reference'}))
    cause = inWordsOfChange (cause);
  end
end

function cause = noGap (cause, gap)
  cause.closed = '';
  missed = strjoin (offTargets (gap, 'holdout'), ', ');
  if ~isempty (missed)
    cause.kind = 'cannot tell';
    cause.word = 'These targets cannot tell';
    cause.sentence = ['What was never fitted is missed by more than noise ', ...
                      'makes: ', missed, '. The fitted targets do not ', ...
                      'show it, so they cannot tell the cause.'];
    cause.notFor = {['what depends on ', missed, ' (never fitted, missed)']};
    cause.action = ['Fit ', missed, ' too (role ''calibrate'') and start ', ...
                    'decalioc run and decalioc diagnose again.'];
    return
  end
  if ~isempty (cause.cannotSee)
    cause.kind = 'cannot tell';
    cause.word = 'These targets cannot tell';
    cause.sentence = ['No gap beyond noise is seen, but these targets ', ...
                      'cannot tell whether one of these is there: ', ...
                      strjoin(cause.cannotSee, ', '), '.'];
    cause.notFor = {['flows in which one of these matters: ', ...
                     strjoin(cause.cannotSee, ', '), ...
                     ' (these targets cannot see it)']};
    cause.action = 'Measure what they move: docs/effects.md lists it.';
    return
  end
  cause.kind = 'none';
  cause.word = 'No gap seen';
  cause.class = 'good';
  cause.sentence = ['No gap beyond noise is seen; a cause weaker than ', ...
                    'what can be seen may still be there.'];
  cause.without = ['What is missed is no more than noise makes: measure ', ...
                   'more precisely, or widen the tolerances (optim.tolRes).'];
end

% A gap whose cause is open; where no measurement is missed, not even that.
function cause = stillOpen (cause, gap)
  likely = strjoin (namesIn (gap.which, 'likely'), ', ');
  [~, isBeyond] = whereText (gap);
  if isBeyond
    cause.word = 'A gap, its cause open';
    cause.sentence = ['Something is missing; what it is stays open: ', ...
                      plainReason(gap.which), '.'];
    if ~isempty (likely)
      cause.sentence = [cause.sentence, ' Most likely: ', likely, '.'];
    end
  else
    cause.kind = 'cannot tell';
    cause.word = 'These targets cannot tell';
    cause.closed = '';
    cause.sentence = ['These targets cannot tell whether something is ', ...
                      'missing.'];
    if ~isempty (likely)
      cause.sentence = [cause.sentence, ' If so, most likely: ', likely, '.'];
    end
  end
  cause.action = testOf (gap);
end

function names = offTargets (gap, roles)
  names = {};
  for t = 1:numel (gap.where.targets)
    own = jsonAt (gap.where.targets, {t});
    if isfield (own, 'p') && isscalar (own.p) && own.p < 0.05 && ...
       any (strcmp (own.role, roles))
      names{end + 1} = own.name;
    end
  end
end

function cause = found (cause, gap, effects)
  which = gap.which;
  [~, isBeyond] = whereText (gap);
  if ~isBeyond
    cause.where = ['No single measurement is missed by more than noise ', ...
                   'makes; together they point to a cause.'];
  end
  cause.kind = 'found';
  cause.class = 'open';
  together = isequal (jsonAt (which, {'together'}), true);
  amounts = cellfun (@(n) amountOf (which, n), effects, ...
                     'UniformOutput', false);
  if strcmp (which.verdict, 'named')
    cause.word = ['Cause found: ', strjoin(effects, ' and ')];
    lead = 'Missing in the model: ';
  elseif numel (effects) > 1 && ~together
    cause.kind = 'several';
    cause.word = ['One of these: ', strjoin(effects, ', ')];
    lead = 'Missing in the model is one of these, which look alike here: ';
  else
    cause.word = ['Likely: ', causeText(which)];
    lead = 'Missing in the model is most likely: ';
  end
  cause.sentence = [lead, strjoin(amounts, '; '), '.'];
  if strcmp (which.verdict, 'group')
    cause.sentence = [cause.sentence, ' Not proved: ', plainReason(which), '.'];
  end
  cause.amount = struct ('label', ['missing: ', strjoin(effects, ', ')], ...
                         'text', strjoin (amounts, '; '));
  own = jsonAt (which, {'strength', matlab.lang.makeValidName(effects{1})});
  if numel (effects) == 1 && ~isempty (jsonAt (own, {'amount'}))
    cause.amount.text = own.amount;
    cause.amount.label = ['missing: ', own.label];
  end
  cause.notFor = {['flows in which ', strjoin(effects, ' or '), ...
                   ' matters, as long as it is not modelled']};
  tried = jsonAt (gap, {'howFar', 'effect'});
  test = testOf (gap);
  if strcmp (cause.kind, 'several')
    cause.action = test;
  elseif ischar (tried) && ~isempty (tried)
    cause.action = ['Model it: gap/calibrated.head holds the lines of ', ...
                    tried, ' for a data.head.'];
  else
    cause.action = 'Model it and calibrate again.';
  end
end

% In its unit; older files know the share of its range alone.
function text = amountOf (which, name)
  own = jsonAt (which, {'strength', matlab.lang.makeValidName(name)});
  text = name;
  if isfield (own, 'text') && ~isempty (own.text)
    text = [name, ', ', own.text];
    if strncmpi (own.text, name, numel (name))
      text = own.text;
    end
  end
  p = jsonAt (which, {'posterior', matlab.lang.makeValidName(name)});
  if ~isempty (p)
    text = sprintf ('%s, probability %.2f', text, p);
  end
end

% The words of the method stay in the field reason.
function text = plainReason (which)
  text = which.reason;
  switch jsonAt (which, {'guard'})
    case 'look-alike'
      if isempty (namesIn (which, 'siblings'))
        text = ['a cause that looks like it, and that nobody listed, ', ...
                'would explain the measurements as well'];
      end
    case 'group'
      text = 'with these targets one is taken for the other';
    case 'integral'
      text = 'the computation did not settle (reason in gap/gap.json)';
  end
end

% A test that tells next to nothing is not named.
function text = testOf (gap)
  test = jsonAt (gap, {'next', 1, 'test'});
  gain = jsonAt (gap, {'next', 1, 'gain'});
  if ischar (test) && ~isempty (gain) && gain >= 0.2
    text = ['Do the test that would tell most: ', test, '.'];
  else
    text = ['No repeat of these tests would tell: measure at another ', ...
            'setting (speed, opening, filling) or on another bench.'];
  end
end

function [text, isBeyond] = whereText (gap)
  where = gap.where;
  models = jsonAt (where, {'models'});
  p = [jsonAt(where, {'p'}), NaN];
  off = offTargets (gap, {'calibrate', 'holdout'});
  isBeyond = ~(p(1) >= 0.05) || ~isempty (off);
  if ~isBeyond
    text = 'No measurement is missed by more than noise makes.';
    return
  end
  text = 'The model misses the measurements together by more than noise makes';
  if ~isempty (off)
    text = ['Missed by more than noise makes: ', strjoin(off, ', ')];
  end
  if isfield (models, 'size') && numel (models) > 1
    [~, k] = max ([models.size]);
    text = [text, '; most of it on ', models(k).model];
  end
  text = [text, '.'];
end

%!test
%! list = verdictCase ();
%! s = list(strcmp ({list.name}, 'met, blind'));
%! cause = decideGap (jsondecode (jsonencode (s.gap)));
%! assert (cause.kind, 'cannot tell');
%! assert (cause.cannotSee, {'cohesion', 'drag'});
