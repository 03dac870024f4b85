% ATLASTLEVEL  Whether a run was made at the level that counts.
%
% CALL: YES = atLastLevel (EFFECTS, CASE)
%
%   EFFECTS  effect values of a run record; the levels stand first
%   CASE     see newCase, or one of its models: coarse is read (1 x v struct;
%            empty: every run counts)
%   YES      logical; a run that knows nothing of levels is one at the last

function yes = atLastLevel (effects, Case)
  coarse = Case.coarse;
  n = min (numel (effects), numel (coarse));
  last = arrayfun (@(c) c.levels(end), coarse(1:n));
  yes = isequal (reshape (effects(1:n), 1, []), reshape (last, 1, []));
end

%!test
%! Case.coarse = struct ('levels', {[4, 3, 2], [1, 0]});
%! assert (atLastLevel ([2; 0; 7], Case));
%! assert (! atLastLevel ([3, 0], Case));
%! assert (atLastLevel ([], Case));
%! assert (atLastLevel ([5, 5], struct ('coarse', [])));

% SPDX-License-Identifier: GPL-3.0-only
