% ADDROWS  Appends evaluations to the table.
%
% CALL: DATA = addRows (DATA, X, Z, REPLICATE, STAGE)
% CALL: DATA = addRows (DATA, X, Z, REPLICATE, STAGE, E)
%
% DATA       struct of newData; with level (see diagnoseCase) the new rows are
%            of the last level
% X          n x d parameters; Z  n x T responses (NaN: failed)
% REPLICATE  n x 1; STAGE  text; E  n x v effect values (default: those of the
%            first row, or zeros)
%
% Parameters are rounded to the digits that a set is run with (toDigits), so that
% equal sets are equal, wherever they come from.
%
% Errors: DEcalioc:addRows:badShape

function data = addRows (data, X, Z, replicate, stage, E)
  n = size (X, 1);
  if nargin < 6
    first = [data.E; zeros(1, columns (data.E))];
    E = repmat (first(1, :), n, 1);
  end
  if columns (X) ~= columns (data.X) || columns (Z) ~= columns (data.Z) || ...
     rows (Z) ~= n || numel (replicate) ~= n
    error ('DEcalioc:addRows:badShape', ...
           ['addRows: X must be n x %d, Z n x %d and replicate n x 1, got ' ...
            '%d x %d, %d x %d and %d x %d.'], columns (data.X), ...
           columns (data.Z), size (X), size (Z), size (replicate));
  end
  data.X = [data.X; toDigits(X)];
  data.E = [data.E; E];
  data.Z = [data.Z; Z];
  data.replicate = [data.replicate; replicate(:)];
  data.stage = [data.stage; repmat({stage}, n, 1)];
  if isfield (data, 'level')
    data.level(end + 1:end + n, :) = 0;
  end
end

%!test
%! data = addRows (newData (2, 1), [1, 2; 3, 4], [5; NaN], [1; 1], 'plan');
%! assert (data.X, [1, 2; 3, 4]);
%! twice = addRows (data, [1 / 3, 0; 1 / 3 + eps(1/3), 0], [1; 1], [1; 2], 'plan');
%! assert (twice.X(3, :), twice.X(4, :), 0);
%! assert (data.stage, {'plan'; 'plan'});

%!error id=DEcalioc:addRows:badShape
%! addRows (newData (2, 1), [1, 2, 3], 1, 1, 'plan');

%!test
%! % no run could be made: the last one, a coarse one, stays one
%! data = addRows (newData (1, 2), 1, [5, 6], 1, 'plan');
%! data.level = [1, 1];
%! none = addRows (data, zeros (0, 1), zeros (0, 2), zeros (0, 1), 'gap');
%! assert (none.level, [1, 1]);
%! assert (addRows (none, 2, [5, 6], 1, 'gap').level, [1, 1; 0, 0]);

% SPDX-License-Identifier: GPL-3.0-only
