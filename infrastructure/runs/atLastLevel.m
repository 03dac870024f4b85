% ATLASTLEVEL  Whether a run was made at the level that counts.
%
% CALL: YES = atLastLevel (EFFECTS, COARSE)
%
%   EFFECTS  effect values of a run record; the levels stand first
%   COARSE   1 x v struct, Case.coarse; [] or empty: every run counts
%   YES      logical; a run that knows nothing of levels is one at the last

function yes = atLastLevel (effects, coarse)
  n = min (numel (effects), numel (coarse));
  last = arrayfun (@(c) c.levels(end), coarse(1:n));
  yes = isequal (reshape (effects(1:n), 1, []), reshape (last, 1, []));
end

%!test
%! coarse = struct ('levels', {[4, 3, 2], [1, 0]});
%! assert (atLastLevel ([2; 0; 7], coarse));
%! assert (! atLastLevel ([3, 0], coarse));
%! assert (atLastLevel ([], coarse) && atLastLevel ([5, 5], []));
