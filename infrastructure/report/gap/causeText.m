% CAUSETEXT  The cause that a verdict tells, in words.
%
% CALL: TEXT = causeText (WHICH)
%
%   WHICH  struct of describeVerdict, or which of gap.json: effects, and where
%          they are there together, lookAlike, siblings
%   TEXT   'a', 'a and b' (together), 'a or b', each perhaps with ', or
%          something that looks like it'; '' where no effect is told

function text = causeText (which)
  text = '';
  effects = namesIn (which, 'effects');
  if isempty (effects)
    return
  end
  joint = ' or ';
  it = 'it';
  if isTrue (which, 'together')
    joint = ' and ';
    it = 'them';
  end
  text = strjoin ([{strjoin(effects, joint)}, namesIn(which, 'siblings')], ...
                  ' or ');
  if isTrue (which, 'lookAlike')
    text = [text, ', or something that looks like ', it];
  end
end

function is = isTrue (which, field)
  is = isfield (which, field) && isequal (which.(field), true);
end

%!test
%! which = struct ('effects', {{'tilt'; 'drag'}}, 'together', true, ...
%!                 'lookAlike', true, 'siblings', []);
%! assert (causeText (which), ...
%!         'tilt and drag, or something that looks like them');
%! which.together = false;
%! assert (causeText (which), ...
%!         'tilt or drag, or something that looks like it');
%! assert (causeText (struct ('effects', 'tilt', 'siblings', {{'gain'}})), ...
%!         'tilt or gain');
%! assert (causeText (struct ('effects', [])), '');
