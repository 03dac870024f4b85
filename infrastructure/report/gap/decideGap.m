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
%     without   what to do then about a set that is not calibrated
%     notFor    cell of texts: what a calibrated set is not to be used for
%     amount    struct label, text: the effect in its unit; []: none
%     cannotSee 1 x n cell, candidates that could not be seen

function cause = decideGap (gap)
  verdict = gap.which;
  effects = namesIn (verdict, 'effects');
  [where, isBeyond] = whereText (gap);
  cause = struct ('kind', 'open', 'word', '', 'sentence', '', 'class', ...
                  'open', 'where', where, 'closed', closedText (gap), ...
                  'action', '', 'without', '', 'notFor', {{}}, 'amount', [], ...
                  'cannotSee', {namesIn(verdict, 'cannotSee')});
  isSeen = ~all (ismember (effects, cause.cannotSee));
  if strcmp (verdict.verdict, 'no gap')
    cause = noGap (cause, gap);
  elseif any (strcmp (verdict.verdict, {'named', 'group'})) && isSeen
    cause = found (cause, gap, effects, isBeyond);
  elseif strcmp (verdict.verdict, 'none of the listed')
    [cause.kind, cause.word, cause.class] = ...
      deal ('unlisted', 'None of the listed causes', 'bad');
    cause.sentence = ['Something is missing, and none of the listed ', ...
                      'causes explains it.'];
    cause.action = ['Add causes that act where the model misses to ', ...
                    'loadEffects.m and start decalioc diagnose again.'];
  elseif strcmp (verdict.verdict, 'surrogate')
    [cause.kind, cause.word] = deal ('no verdict', ...
                                     'No verdict on the gap: too few runs');
    cause.sentence = ['The runs do not allow a verdict on the gap: ', ...
                      verdict.reason, '.'];
    cause.action = 'Raise Input.maxNewRuns, start decalioc diagnose again.';
  else
    cause = stillOpen (cause, gap, isBeyond);
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
  missed = strjoin (missedTargets (gap, 'holdout'), ', ');
  unseen = strjoin (cause.cannotSee, ', ');
  if isempty (missed) && isempty (unseen)
    [cause.kind, cause.word, cause.class] = deal ('none', 'No gap seen', ...
                                                  'good');
    cause.sentence = ['No gap beyond noise is seen; a cause weaker than ', ...
                      'what can be seen may still be there.'];
    cause.without = ['What is missed is no more than noise makes: measure ', ...
                     'more precisely, or widen the tolerances (optim.tolRes).'];
    return
  end
  [cause.kind, cause.word] = deal ('cannot tell', 'These targets cannot tell');
  if isempty (missed)
    cause.sentence = ['No gap beyond noise is seen, but these targets ', ...
                      'cannot tell whether one of these is there: ', ...
                      unseen, '.'];
    cause.notFor = {['flows in which one of these matters: ', unseen, ...
                     ' (these targets cannot see it)']};
    cause.action = 'Measure what they move: docs/effects.md lists it.';
  else
    cause.sentence = ['What was never fitted is missed by more than noise ', ...
                      'makes: ', missed, '. The fitted targets do not ', ...
                      'show it, so they cannot tell the cause.'];
    cause.notFor = {['what depends on ', missed, ' (never fitted, missed)']};
    cause.action = ['Fit ', missed, ' too (role ''calibrate'') and start ', ...
                    'decalioc run and decalioc diagnose again.'];
  end
end

% A gap whose cause is open; where no measurement is missed, not even that.
function cause = stillOpen (cause, gap, isBeyond)
  if isBeyond
    cause.word = 'A gap, its cause open';
    cause.sentence = ['Something is missing; what it is stays open: ', ...
                      plainReason(gap.which), '.'];
    lead = ' Most likely: ';
  else
    [cause.kind, cause.word] = deal ('cannot tell', ...
                                     'These targets cannot tell');
    cause.closed = '';
    cause.sentence = ['These targets cannot tell whether something is ', ...
                      'missing.'];
    lead = ' If so, most likely: ';
  end
  likely = strjoin (namesIn (gap.which, 'likely'), ', ');
  if ~isempty (likely)
    cause.sentence = [cause.sentence, lead, likely, '.'];
  end
  cause.action = testOf (gap);
end

function cause = found (cause, gap, effects, isBeyond)
  verdict = gap.which;
  if ~isBeyond
    cause.where = ['No single measurement is missed by more than noise ', ...
                   'makes; together they point to a cause.'];
  end
  cause.kind = 'found';
  isAlone = isscalar (effects) || isequal (jsonAt (verdict, {'together'}), 1);
  isItself = ~isequal (jsonAt (verdict, {'lookAlike'}), true);
  isNamed = strcmp (verdict.verdict, 'named');
  if isNamed
    cause.word = ['Cause found: ', strjoin(effects, ' and '), ...
                  repmat(', or its like', 1, ~isItself)];
    lead = 'Missing in the model: ';
  elseif isAlone
    cause.word = ['Likely: ', causeText(verdict)];
    lead = 'Missing in the model is most likely: ';
  else
    cause.kind = 'several';
    cause.word = ['One of these: ', strjoin(effects, ', ')];
    lead = 'Missing in the model is one of these, which look alike here: ';
    if isequal (jsonAt (verdict, {'sameKind'}), true)
      cause.word = ['One kind of cause: ', strjoin(effects, ' or ')];
      lead = ['Missing in the model is one of these, which move these ', ...
              'targets in nearly the same way: '];
    end
  end
  known = cellfun (@(n) jsonAt (verdict, {'strength', ...
                                          matlab.lang.makeValidName(n)}), ...
                   effects, 'UniformOutput', false);
  amounts = strjoin (cellfun (@(n, s) amountOf (verdict, n, s), effects, ...
                              known, 'UniformOutput', false), '; ');
  cause.sentence = [lead, amounts, '.'];
  if ~isNamed
    cause.sentence = [cause.sentence, ' Not proved: ', ...
                      plainReason(verdict), '.'];
  elseif ~isItself
    cause.sentence = [cause.sentence, ' This or a cause that moves these ', ...
                      'targets in nearly the same way; they do not tell ', ...
                      'which of the two.'];
  end
  cause.amount = struct ('label', ['missing: ', strjoin(effects, ', ')], ...
                         'text', amounts);
  if numel (effects) == 1 && ~isempty (jsonAt (known{1}, {'amount'}))
    cause.amount.text = known{1}.amount;
    cause.amount.label = ['missing: ', known{1}.label];
  end
  cause.notFor = {['flows in which ', strjoin(effects, ' or '), ...
                   ' matters, as long as it is not modelled']};
  tried = jsonAt (gap, {'howFar', 'effect'});
  if strcmp (cause.kind, 'several')
    cause.action = testOf (gap);
  elseif isempty (tried)
    cause.action = 'Model it and calibrate again.';
  else
    cause.action = ['Model it: gap/calibrated.head holds the lines of ', ...
                    tried, ' for a data.head.'];
  end
end

% In its unit; older files know the share of its range alone.
function text = amountOf (verdict, name, known)
  text = name;
  strength = jsonAt (known, {'text'});
  if strncmpi (strength, name, numel (name))
    text = strength;
  elseif ~isempty (strength)
    text = [name, ', ', strength];
  end
  field = matlab.lang.makeValidName (name);
  p = [jsonAt(verdict, {'alike', field}), ...
       jsonAt(verdict, {'posterior', field})];
  if ~isempty (p)
    text = sprintf ('%s, probability %.2f', text, p(1));
  end
end

% The words of the method stay in the field reason.
function text = plainReason (verdict)
  text = verdict.reason;
  guard = jsonAt (verdict, {'guard'});
  if strcmp (guard, 'look-alike') && isempty (namesIn (verdict, 'siblings'))
    text = ['a cause that looks like it, and that nobody listed, ', ...
            'would explain the measurements as well'];
  elseif strcmp (guard, 'group')
    text = 'with these targets one is taken for the other';
  elseif strcmp (guard, 'integral')
    text = 'the computation did not settle (reason in gap/gap.json)';
  end
end

% A test that tells next to nothing is not named.
function text = testOf (gap)
  first = jsonAt (gap, {'next', 1});
  if any (jsonAt (first, {'gain'}) >= 0.2)
    text = ['Do the test that would tell most: ', first.test, '.'];
  else
    text = ['No repeat of these tests would tell: measure at another ', ...
            'setting (speed, opening, filling) or on another bench.'];
  end
end

function [text, isBeyond] = whereText (gap)
  models = jsonAt (gap, {'where', 'models'});
  off = missedTargets (gap, {'calibrate', 'holdout'});
  isBeyond = ~isequal (jsonAt (gap, {'where', 'p'}) >= 0.05, true) || ...
             ~isempty (off);
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
%! kinds = {'met, no gap', 'none'; 'met, blind', 'cannot tell'; ...
%!          'met, named', 'found'; 'missed, several', 'several'; ...
%!          'missed, none listed', 'unlisted'; 'missed, undecided', 'open'; ...
%!          'missed, surrogate', 'no verdict'};
%! list = verdictCase ();
%! for row = kinds'
%!   gap = list(strcmp ({list.name}, row{1})).gap;
%!   assert (decideGap (jsondecode (jsonencode (gap))).kind, row{2});
%! end
