% FOREIGNVALUE  Value of one effect, neutral where a law is told nothing of it.
%
% CALL: V = foreignValue (E, NAME, NEUTRAL)
%
%   E        struct of n x 1 values by the name of the effect
%   NAME     text;  NEUTRAL  scalar
%   V        n x 1 or scalar
%
% See also: foreignLab

function v = foreignValue (e, name, neutral)
  v = neutral;
  if isfield (e, name)
    v = e.(name);
  end
end

%!assert (foreignValue (struct ('tilt', [1; 2]), 'tilt', 0), [1; 2])
%!assert (foreignValue (struct (), 'tilt', 7), 7)
