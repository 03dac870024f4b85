% WITHNEWRUNS  The runs of a diagnosis, in the units and columns of its user.
%
% CALL: DATA = withNewRuns (DATA, STATE, KNOWN, PROBLEM)
%
%   DATA        as given to the diagnosis;  KNOWN  what enterRuns made of it
%   STATE       of newGapState, whose rows beyond KNOWN are new
%   PROBLEM     of enterRuns: kept and unit are read
%   DATA        the same with the new rows, NaN for targets that are left out

function data = withNewRuns (data, state, known, problem)
  new = rows (known.X) + 1:rows (state.data.X);
  absent = struct ('Z', NaN, 'level', 0);
  % back from units of the noise (enterRuns)
  unit = struct ('Z', problem.unit, 'level', 1);
  for name = fieldnames (data)'
    added = state.data.(name{1})(new, :);
    if isfield (absent, name{1})             % a column a target
      added = absent.(name{1}) * ones (numel (new), columns (data.Z));
      added(:, problem.kept) = state.data.(name{1})(new, :) .* unit.(name{1});
    end
    data.(name{1}) = [data.(name{1}); added];
  end
end

%!test
%! data = struct ('X', 1, 'E', zeros (1, 0), 'Z', [3, 4], 'replicate', 1);
%! known = setfield (data, 'Z', 8);
%! state.data = struct ('X', [1; 2], 'E', zeros (2, 0), 'Z', [8; 10], ...
%!                      'replicate', [1; 1]);
%! own = withNewRuns (data, state, known, struct ('kept', 2, 'unit', 0.5));
%! assert ({own.X, own.Z}, {[1; 2], [3, 4; NaN, 5]});

% SPDX-License-Identifier: GPL-3.0-only
