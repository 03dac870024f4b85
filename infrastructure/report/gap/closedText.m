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
  if ~ischar (effect) || isempty (effect)
    return
  end
  isVerified = isequal (jsonAt (far, {'verifiedByDEM'}), true);
  how = {'closed.onSurrogates', 'closed.byDEM'};
  code = codeOf (far);
  values = struct ('effect', plainName (effect), 'how', sentence (how{1 + isVerified}), ...
                   'part', partText (far, isChange));
  text = sentence ('closed.fitted', values);
  held = jsonAt (far, {'heldOut'});
  if isstruct (held)
    text = [text, '; ', ...
            sentence('closed.heldOut', struct ('part', partText (held, isChange)))];
  end
  text = [text, '.', outsideText(far), rivalText(far)];
end

% Within noise is not yet within what the user allows.
function text = outsideText (far)
  text = '';
  names = {};
  for k = 1:numel (jsonAt (far, {'targets'}))
    T = jsonAt (far, {'targets', k});
    allowed = jsonAt (T, {'allowed'});
    if strcmp (jsonAt (T, {'role'}), 'calibrate') && any (abs (T.after - T.measured) > allowed)
      names{end + 1} = T.name;
    end
  end
  if ~isempty (names)
    text = [' ', sentence('closed.outside', struct ('names', {names}))];
  end
end

function text = partText (part, isChange)
  share = round (100 * jsonAt (part, {'closure'}));
  text = sentence (['closed.', codeOf(part)], struct ('share', share), isChange);
end

% No gap, and a gap whose closing cannot be told, are two things.
function code = codeOf (part)
  closure = jsonAt (part, {'closure'});
  removable = jsonAt (part, {'removable'});
  code = 'share';
  if any (diff (jsonAt (part, {'interval90'})) > 0.5)
    code = 'unsure';
  elseif any (closure >= 0.995)
    code = 'all';
  elseif any (closure <= 0.005)
    code = 'nothing';
  elseif ~any (isfinite (closure)) && isequal (removable, true)
    code = 'tooFew';
  elseif ~any (isfinite (closure)) && isequal (removable, false)
    code = 'noise';
  elseif ~any (isfinite (closure))
    code = 'unknown';
  end
end

% The placebo that does as well is the rival.
function text = rivalText (far)
  text = '';
  rivals = {};
  for k = 1:numel (jsonAt (far, {'placebos'}))
    placebo = jsonAt (far, {'placebos', k});
    closure = jsonAt (placebo, {'closure'});
    isRival = jsonAt (placebo, {'against'});
    if isempty (isRival)
      isRival = any (closure >= 0.8 * min (far.closure, 1));
    end
    if isRival
      rivals{end + 1} = placebo.effect;
    end
  end
  if ~isempty (rivals)
    text = [' ', sentence('closed.rivals', struct ('names', {rivals}))];
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
