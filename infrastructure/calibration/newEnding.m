% NEWENDING  How a calibration ended: a code with its numbers.
%
% CALL: ENDING = newEnding (CODE, NUMBERS [, OPTIONS])
%
%   CODE     'converged', 'conflict', 'allFailed', 'notRun', 'outside',
%            'equalRuns', 'fewRuns', 'unsure', 'twoOutcomes', 'noResult', 'unjudged', 'open',
%            'published', 'beyondScatter',
%            those of endingCause, see ending.* of
%            words.txt
%   NUMBERS  struct with some of: runs (at the set), equal, probability,
%            conflict (cellstr of targets), limit ('maxFunEvals', 'maxNewRuns',
%            'maxIter': the budget that ended the search; 'unsettled': what is left
%            of them would not settle it; '': none), usual,
%            other (runs at the set that end as most do, in another way), share
%            (expected of other ones), none, resulting (runs at the set without and
%            with a result), names (cellstr, of what is open or unjudged), restMet (logical,
%            of 'unjudged': the other targets are met), stopped, rest
%   OPTIONS  struct with the limits (optim.maxFunEvals ...), replicates
%   ENDING   struct: code, and the numbers; text, the sentence for them
%
% Whoever decides what to do next looks at code and limit, never at text.

function ending = newEnding (code, numbers, options)
  if nargin < 3
    options = struct ();
  end
  ending = mergeFields (struct ('code', code, 'runs', 0, 'equal', 0, ...
                                'probability', 0, 'conflict', {{}}, ...
                                'limit', '', 'usual', 0, 'other', 0, ...
                                'none', 0, 'resulting', 0, 'share', 0, ...
                                'outside', 0, 'targets', 0, 'names', {{}}), numbers);
  values = ending;
  values.share = round (100 * values.share);
  values.all = values.usual + values.other;
  values.tried = values.none + values.resulting;
  chance = 100 * values.probability;
  values.probability = round (chance);
  if chance > 99.5                       % never said to be certain
    values.probability = 'more than 99';
  end
  values.equal = values.equal + values.runs;
  values.wanted = givenField (options, 'replicates', 1);
  values.together = repmat (' at once', 1, numel (ending.conflict) > 1);
  values.limited = '';
  if ~isempty (ending.limit)
    values.most = givenField (options, ending.limit, NaN);
    values.limited = sentence (['limit.', ending.limit], values);
  end
  if strcmp (code, 'unjudged')
    values.rest = sentence (['ending.unjudged.', restCode(ending)]);
  elseif strcmp (code, 'twoOutcomes') && ending.other == 0
    code = 'twoOutcomes.earlier';
  end
  ending.text = sentence (['ending.', code], values);
end

function code = restCode (ending)
  code = 'missed';
  if givenField (ending, 'restMet', false)
    code = 'met';
  end
end

%!test
%! ending = newEnding ('outside', struct ('runs', 2, 'limit', 'maxIter'), ...
%!                     struct ('maxIter', 3));
%! assert ({ending.code, ending.limit, ending.runs}, {'outside', 'maxIter', 2});
%! assert (! isempty (strfind (ending.text, 'optim.maxIter (3)')));
%! told = newEnding ('twoOutcomes', struct ('usual', 6, 'share', 0.09));
%! assert ({told.code, isempty(strfind (told.text, 'form.csv'))}, {'twoOutcomes', false});
%!test
%! text = newEnding ('converged', struct ('runs', 1, 'probability', 0.998)).text;
%! assert (isempty (strfind (text, '100 %')));
%!test
%! % every code has a sentence
%! for code = {'converged', 'conflict', 'allFailed', 'notRun', 'outside', ...
%!             'equalRuns', 'fewRuns', 'unsure', 'twoOutcomes', 'noResult', ...
%!             'unjudged', 'open'}
%!   assert (! isempty (newEnding (code{1}, struct ()).text));
%! end

% SPDX-License-Identifier: GPL-3.0-only
