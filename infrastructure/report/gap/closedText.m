% CLOSEDTEXT  How much of the gap the cause takes away, in words.
%
% CALL: TEXT = closedText (GAP)
%
%   GAP   decoded gap/gap.json
%   TEXT  one sentence, and one about rivals where there are; '': not tried

function text = closedText (gap)
  far = jsonAt (gap, {'howFar'});
  effect = jsonAt (far, {'effect'});
  text = '';
  if ~ischar (effect) || isempty (effect)
    return
  end
  how = {'on the surrogates, not yet by DEM runs', 'by DEM runs'};
  isVerified = isequal (jsonAt (far, {'verifiedByDEM'}), true);
  text = ['With ', effect, ' (', how{1 + isVerified}, ...
          '): of the gap on the fitted targets ', partText(far)];
  held = jsonAt (far, {'heldOut'});
  if isstruct (held)
    text = [text, '; on the held-out ones ', partText(held)];
  end
  text = [text, '.', rivalText(far)];
end

% No gap, and a gap whose closing cannot be told, are two things.
function text = partText (part)
  closure = jsonAt (part, {'closure'});
  if isempty (closure) || ~isfinite (closure)
    removable = jsonAt (part, {'removable'});
    text = 'it cannot be judged';
    if isequal (removable, true)
      text = [text, ' from so few targets: the fit has as many unknowns'];
    elseif isequal (removable, false)
      text = 'none is beyond noise';
    end
  elseif closure >= 0.995
    text = 'all is closed';
  elseif closure <= 0.005
    text = 'nothing is closed';
  else
    text = sprintf ('%.0f %% is closed', 100 * closure);
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
    text = [' As much is closed by ', strjoin(rivals, ', '), ...
            ': the fit alone does not prove the cause.'];
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
