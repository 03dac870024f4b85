% CLOSEDTEXT  How much of the gap the cause takes away, in words.
%
% CALL: [TEXT, CODE] = closedText (GAP [, ISCHANGE])
%
%   GAP   decoded gap/gap.json
%   ISCHANGE  logical (false): said of a change, see sentence
%   TEXT  one sentence, and one about rivals where there are; '': not tried
%   CODE  of closed.* in words.txt, for the fitted targets: 'share', 'all',
%         'nothing', 'tooFew', 'noise', 'unsure' (its interval is wider than
%         half), 'unknown'; '': not tried

function [text, code] = closedText (gap, isChange)
  far = jsonAt (gap, {'howFar'});
  effect = jsonAt (far, {'effect'});
  [text, code] = deal ('');
  isChange = nargin > 1 && isChange;
  if isempty (effect)
    return
  end
  code = codeOf (far);
  said = struct ('effect', plainName (effect), 'how', judgedHow (far), 'part', ...
                 partText (far, isChange));
  held = jsonAt (far, {'heldOut'});
  last = far;
  if ~isstruct (held)
    text = sentence ('closed.fitted', said);
  elseif strcmp (codeOf (held), code) && isequal (percentOf (held), percentOf (far))
    text = sentence ('closed.both', said);
  else
    last = held;
    text = [sentence('closed.fitted', said), doubtOf(far, held), '; ', ...
            sentence('closed.heldOut', struct ('part', partText (held, isChange)))];
  end
  text = [text, doubtOf(last)];
  targets = jsonList (far, {'targets'});
  placebos = jsonList (far, {'placebos'});
  outside = targets(cellfun (@isOutside, targets));
  rivals = placebos(cellfun (@(p) isRival (p, far), placebos));
  rest = listSentences ({'closed.outside', eachOf(@(T) T.name, outside); ...
                         'closed.rivals', eachOf(@(p) p.effect, rivals)});
  text = [text, '.', strcat({' '}, rest){:}];
end

% Within noise is not yet within what the user allows.
function yes = isOutside (T)
  yes = strcmp (jsonAt (T, {'role'}), 'calibrate') && ...
        any (abs (T.after - T.measured) > jsonAt (T, {'allowed'}));
end

% One that does as well.
function yes = isRival (placebo, far)
  isAsGood = any (jsonAt (placebo, {'closure'}) >= 0.8 * min (far.closure, 1));
  yes = givenField (placebo, 'against', isAsGood);
end

function text = partText (part, isChange)
  text = sentence (['closed.', codeOf(part)], struct ('share', percentOf (part)), isChange);
end

% Behind the last part of which it holds.
function text = doubtOf (part, next)
  text = '';
  if strcmp (codeOf (part), 'unsure') && (nargin < 2 || ~strcmp (codeOf (next), 'unsure'))
    text = [' ', sentence('closed.doubt')];
  end
end

% Over 100 %: less is left than noise and the error of the simulations make.
function share = percentOf (part)
  share = min (round (100 * jsonAt (part, {'closure'})), 100);
end

% No gap, and a gap whose closing cannot be told, are two things.
function code = codeOf (part)
  closure = jsonNumber (part, {'closure'});
  removable = jsonNumber (part, {'removable'});
  if any (diff (jsonAt (part, {'interval90'})) > 0.5)
    code = 'unsure';
  elseif ~isfinite (closure) && isnan (removable)
    code = 'unknown';
  elseif ~isfinite (closure)
    code = merge (removable == 0, 'noise', 'tooFew');
  elseif closure >= 0.995
    code = 'all';
  elseif closure <= 0.005
    code = 'nothing';
  else
    code = 'share';
  end
end

%!test
%! % no gap, and a gap that cannot be judged, are two things
%! far = struct ('effect', 'tilt', 'closure', 1.21, 'verifiedByDEM', true, ...
%!               'placebos', [], 'heldOut', struct ('closure', [], ...
%!                                                  'removable', false));
%! [text, code] = closedText (struct ('howFar', far));
%! assert (code, 'all');
%! assert (! isempty (strfind (text, sentence ('closed.noise'))));
%! far.interval90 = [0.5, 1.1];
%! assert (nthargout (2, @closedText, struct ('howFar', far)), 'unsure');
%! text = closedText (struct ('howFar', far));
%! assert (! isempty (strfind (text, 'about 100 %')), text);
%! % one share of both kinds of data is said once
%! both = setfield (far, 'heldOut', struct ('closure', 1.1, 'interval90', [0.4, 1.2]));
%! text = closedText (struct ('howFar', both));
%! assert (numel (strfind (text, 'about 100 %')), 1);
%! assert (! isempty (strfind (text, 'on the fitted data and on data not used')), text);
%! % where they differ their doubt is
%! both.heldOut.closure = 0.3;
%! text = closedText (struct ('howFar', both));
%! assert (numel (strfind (text, 'uncertain')), 1);
%! assert (! isempty (regexp (text, 'about 30 %.* not used in the fit \(uncertain')), text);
%! both.heldOut.interval90 = [0.2, 0.4];
%! text = closedText (struct ('howFar', both));
%! assert (! isempty (regexp (text, 'fitted data \(uncertain[^;]*\); 30 %')), text);
%! far = rmfield (far, 'interval90');
%! far.heldOut = [];
%! [far.closure, far.removable] = deal ([], true);
%! assert (nthargout (2, @closedText, struct ('howFar', far)), 'tooFew');
%! far.closure = 1.21;
%! far.heldOut = struct ('closure', []);
%! far.placebos = struct ('effect', 'drag', 'closure', 0.98);
%! text = closedText (struct ('howFar', far));
%! assert (! isempty (strfind (text, sentence ('closed.unknown'))));
%! assert (! isempty (strfind (text, sentence ('closed.rivals', ...
%!                                             struct ('names', 'drag')))));
%! assert (closedText (struct ('howFar', struct ('effect', ''))), '');

% SPDX-License-Identifier: GPL-3.0-only
