% OPENSUSPECTS  Runs that look wrong, and whose set was not run once more.
%
% CALL: YES = openSuspects (STATE, PROBLEM)
%
%   YES  n x 1 logical, rows of STATE.data

function yes = openSuspects (state, problem)
  data = state.data;
  yes = false (rows (data.X), 1);
  suspect = any (horzcat (state.surrogates.suspect), 2);
  for i = find (suspect)'
    isSame = sameSet (data.X, data.X(i, :), problem.limits) & ...
             all (data.E == data.E(i, :), 2);
    yes(i) = sum (isSame) == 1;
  end
end

%!test
%! [problem, state] = smallCalibration ();
%! assert (openSuspects (state, problem), false (12, 1));
%! state.surrogates(1).suspect([2, 5]) = true;
%! state.data = addRows (state.data, state.data.X(5, :), NaN (1, 2), 2, ...
%!                       'repeat');
%! state.surrogates(1).suspect(13) = false;
%! state.surrogates(2).suspect(13) = false;
%! assert (find (openSuspects (state, problem)), 2);

% SPDX-License-Identifier: GPL-3.0-only
