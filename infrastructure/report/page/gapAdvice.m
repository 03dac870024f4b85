% GAPADVICE  What a diagnosis means, and what to do, in words.
%
% CALL: [WORD, SENTENCE, ADVICE, CLASS] = gapAdvice (PAGE)
%
%   PAGE      see pageData, with sources.gap
%   WORD      the verdict in a few words (text)
%   SENTENCE  what was found (HTML)
%   ADVICE    what to do now (cell of HTML)
%   CLASS     'good', 'bad' or 'open'
%
% See also: pageVerdict, sectionWhich

function [word, sentence, advice, class] = gapAdvice (page)
  which = page.sources.gap.which;
  effects = namesIn (which, 'effects');
  likely = namesIn (which, 'likely');
  class = 'open';
  reason = which.reason;
  sentence = [htmlText([upper(reason(1)), reason(2:end)]), '. ', ...
              howSure(page, effects)];
  test = nextOf (page);
  switch which.verdict
    case 'no gap'
      word = 'No gap beyond noise';
      class = 'good';
      advice = {['Use the model. An effect weaker than what can be seen (', ...
                 'table below) may still be there.']};
    case 'named'
      word = ['Cause found: ', strjoin(effects, ' and ')];
      class = 'good';
      advice = {['Model ', htmlText(strjoin (effects, ' and ')), ': ', ...
                 '<code>gap/calibrated.head</code> holds the lines. ', ...
                 'Look at the held-out targets before you trust it.']};
    case 'group'
      [word, advice] = ofGroup (which, effects, test);
    case 'none of the listed'
      word = 'None of the listed causes';
      class = 'bad';
      advice = {['Do not model any of the listed effects: none fits. The ', ...
                 'map below shows where the gap is; add causes that act ', ...
                 'there to <code>loadEffects.m</code>.']};
    case 'undecided'
      word = 'A gap, its cause undecided';
      advice = {['The most likely causes are ', ...
                 htmlText(strjoin (likely, ', ')), '. ', test]};
    case 'surrogate'
      word = 'No verdict: too few runs';
      class = 'bad';
      advice = {['The surrogates are to blame, not the model. Allow more ', ...
                 'runs (<code>Input.maxNewRuns</code>) and start again.']};
    otherwise
      word = which.verdict;
      advice = {test};
  end
  advice = advice(~cellfun (@isempty, advice));
end

% One of several, or one cause (a pair, too) whose name was withheld.
function [word, advice] = ofGroup (which, effects, test)
  if numel (effects) > 1 && ~isequal (jsonAt (which, {'together'}), true)
    word = ['One of these: ', strjoin(effects, ', ')];
    advice = {['The causes named look alike with these targets. ', test]};
  else
    word = ['Likely: ', causeText(which)];
    advice = {['Model it, but do not call it proved: a cause that you did ', ...
               'not list may do the same. ', test]};
  end
end

function text = howSure (page, effects)
  text = '';
  if isempty (effects) || ~isempty (strfind (page.sources.gap.which.reason, ...
                                             'probability'))
    return
  end
  parts = cell (1, numel (effects));
  for k = 1:numel (effects)
    name = matlab.lang.makeValidName (effects{k});
    parts{k} = [htmlText(effects{k}), ' ', ...
                pageNumber(page, 'probability', 'gap', 'which', ...
                           'posterior', name)];
  end
  text = ['Probability: ', strjoin(parts, ', '), '.'];
end

function text = nextOf (page)
  text = '';
  test = jsonAt (page.sources.gap, {'next', 1, 'test'});
  if ischar (test)
    text = ['Do the test that would tell most: <strong>', htmlText(test), ...
            '</strong>.'];
  end
end

%!function page = told (verdict)
%!  page.sources.gap = jsondecode (sprintf (['{"which": {"verdict": "%s", ', ...
%!    '"reason": "because", "effects": ["tilt"], "likely": ["tilt"], ', ...
%!    '"posterior": {"tilt": 0.75}}, "next": [{"test": "drum", ', ...
%!    '"gain": 1}]}'], verdict));
%!endfunction
%!test
%! % every verdict of docs/gap.md leads to an advice of its own
%! kinds = {'no gap', 'named', 'group', 'none of the listed', 'undecided', ...
%!          'surrogate'};
%! words = cell (size (kinds));
%! for k = 1:numel (kinds)
%!   [words{k}, sentence, advice, class] = gapAdvice (told (kinds{k}));
%!   assert (numel (advice), 1);
%!   assert (! isempty (strfind (sentence, '0.75')));
%! end
%! assert (numel (unique (words)), 6);
%! [word, ~, advice] = gapAdvice (told ('group'));
%! assert (word, 'Likely: tilt');
%! assert (! isempty (strfind (advice{1}, '<strong>drum</strong>')));
%!test
%! % several: one of them, or all of them together
%! page = told ('group');
%! page.sources.gap.which.effects = {'tilt'; 'drag'};
%! page.sources.gap.which.posterior.drag = 0.5;
%! page.sources.gap.which.lookAlike = true;
%! assert (gapAdvice (page), 'One of these: tilt, drag');
%! page.sources.gap.which.together = true;
%! assert (gapAdvice (page), ...
%!         'Likely: tilt and drag, or something that looks like them');
