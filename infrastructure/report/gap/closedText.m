% CLOSEDTEXT  How much of the gap the cause takes away, in words.
%
% CALL: [TEXT, CODE] = closedText (GAP [, ISCHANGE])
%
%   GAP   decoded gap/gap.json
%   ISCHANGE  logical (false): said of a change, see sentence
%   TEXT  one sentence, and one about rivals where there are; '': not tried
%   CODE  of closed.* in words.txt, for the fitted targets: 'share', 'all',
%         'nothing', 'tooFew', 'noise', 'unknown'; '': not tried

function [text, code] = closedText (gap, isChange)
  far = jsonAt (gap, {'howFar'});
  effect = jsonAt (far, {'effect'});
  [text, code] = deal ('');
  if ~ischar (effect) || isempty (effect)
    return
  end
  isVerified = isequal (jsonAt (far, {'verifiedByDEM'}), true);
  how = {'closed.onSurrogates', 'closed.byDEM'};
  code = codeOf (far);
  values = struct ('effect', effect, 'how', sentence (how{1 + isVerified}), ...
                   'part', partText (far));
  text = sentence ('closed.fitted', values, nargin > 1 && isChange);
  held = jsonAt (far, {'heldOut'});
  if isstruct (held)
    text = [text, '; ', ...
            sentence('closed.heldOut', struct ('part', partText (held)))];
  end
  text = [text, '.', rivalText(far)];
end

function text = partText (part)
  share = round (100 * jsonAt (part, {'closure'}));
  text = sentence (['closed.', codeOf(part)], struct ('share', share));
end

% No gap, and a gap whose closing cannot be told, are two things.
function code = codeOf (part)
  closure = jsonAt (part, {'closure'});
  removable = jsonAt (part, {'removable'});
  code = 'share';
  if any (closure >= 0.995)
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
%! assert (closedText (struct ('howFar', far)), ...
%!         ['With tilt (by DEM runs): of the gap on the fitted targets ', ...
%!          'all is closed; on the held-out ones none is beyond noise.']);
%! far.heldOut = [];
%! [far.closure, far.removable] = deal ([], true);
%! assert (! isempty (strfind (closedText (struct ('howFar', far)), ...
%!         'it cannot be judged from so few targets')));
%! far.closure = 1.21;
%! far.heldOut = struct ('closure', []);
%! far.placebos = struct ('effect', 'drag', 'closure', 0.98);
%! text = closedText (struct ('howFar', far));
%! assert (! isempty (strfind (text, 'ones it cannot be judged.')));
%! assert (! isempty (strfind (text, 'As much is closed by drag')));
%! assert (closedText (struct ('howFar', struct ('effect', ''))), '');
