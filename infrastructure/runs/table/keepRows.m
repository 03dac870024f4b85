% KEEPROWS  Some rows of the table of evaluations.
%
% CALL: DATA = keepRows (DATA, WHICH)
%
% DATA   struct of newData, n rows; or any whose fields have n rows
% WHICH  n x 1 logical, or row numbers

function data = keepRows (data, which)
  for name = fieldnames (data)'
    data.(name{1}) = data.(name{1})(which, :);
  end
end

%!test
%! data = addRows (newData (1, 1, 1), [1; 2], [3; 4], [1; 1], 'plan', [2; 1]);
%! kept = keepRows (data, [false; true]);
%! assert ({kept.X, kept.E, kept.Z, kept.stage}, {2, 1, 4, {'plan'}});

% SPDX-License-Identifier: GPL-3.0-only
