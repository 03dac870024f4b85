% CAUSETEXT  The cause that a verdict tells, in words.
%
% CALL: TEXT = causeText (WHICH)
%
%   WHICH  which of gap.json: effects, and where they are there together,
%          lookAlike, siblings
%   TEXT   'a', 'a and b' (together), 'a or b', each perhaps with ', or
%          something that looks like it'

function text = causeText (which)
  is = @(field) isequal (jsonAt (which, {field}), true);
  joints = {' or ', ' and '};
  objects = {'it', 'them'};
  own = strjoin (plainName (namesIn (which, 'effects')), joints{1 + is('together')});
  text = strjoin ([{own}, plainName(namesIn (which, 'siblings'))], ' or ');
  if is ('lookAlike')
    text = [text, ', or something that looks like ', ...
            objects{1 + is('together')}];
  end
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
