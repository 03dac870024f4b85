% PERTARGET  Spreads a field given per model, as a column or once, on targets.
%
% CALL: PARTS = perTarget (VALUES, COUNTS, DEFAULT)
%
%   VALUES   as checkTargetNumbers lets it pass: a cell of vectors, {k}(i) for
%            target i of model k, {k} one number for a model or []; or one
%            vector of all targets; or one number for all; [] for none
%   COUNTS   1 x M, targets of each model
%   DEFAULT  scalar, where nothing is given
%   PARTS    1 x M cell of 1 x COUNTS(k)
%
% See also: newCase, checkTargetNumbers

function parts = perTarget (values, counts, default)
  if isempty (values)
    values = default;
  end
  if ~iscell (values) && isscalar (values)
    values = repmat ({values}, 1, numel (counts));
  elseif ~iscell (values)
    values = mat2cell (values(:)', 1, counts);
  end
  parts = arrayfun (@(n) repmat (default, 1, n), counts(:)', ...
                    'UniformOutput', false);
  for k = 1:numel (values)
    own = double (values{k}(:)');
    if isscalar (own)
      own = repmat (own, 1, counts(k));
    end
    parts{k}(1:numel (own)) = own;
  end
end

%!assert (perTarget ({[1; 2], 3}, [2, 1], 0), {[1, 2], 3})
%!assert (perTarget ({[], 3}, [2, 2], 1), {[1, 1], [3, 3]})
%!assert (perTarget ({4}, [2, 1], 1), {[4, 4], 1})
%!assert (perTarget ([1; 2; 3], [2, 1], 0), {[1, 2], 3})
%!assert (perTarget (int8 (7), [2, 1], 0), {[7, 7], 7})
%!assert (perTarget ({}, [2, 1], 1), {[1, 1], 1})
