% CHECKELEMENTS  Lists the numbers of a field given per model or as a column.
%
% CALL: [VALUES, FIELDS, SIZES] = checkElements (VALUE, PREFIX)
%
%   VALUE   anything; good are a cell of M vectors of real numbers, or one
%           vector of real numbers
%   PREFIX  how the user writes it, e.g. 'optim.tolRes' (text)
%   VALUES  1 x n double, all numbers, model by model
%   FIELDS  1 x n cell, how each is written, e.g. 'optim.tolRes{1}(2)'
%   SIZES   1 x M, numbers of each model of the cell; the number of all for
%           one vector; [] where VALUE is of no good kind
%
% See also: checkTargets, checkTargetNumbers

function [values, fields, sizes] = checkElements (value, prefix)
  values = zeros (1, 0);
  fields = cell (1, 0);
  sizes = [];
  if checkIs ('vector', value)
    values = double (value(:)');
    fields = numbered (prefix, numel (value));
    sizes = numel (value);
    return
  end
  if ~iscell (value) || ~isvector (value) || ...
      ~all (cellfun (@isPart, value(:)'))
    return
  end
  for k = 1:numel (value)
    values = [values, double(value{k}(:)')];
    fields = [fields, numbered(sprintf ('%s{%d}', prefix, k), ...
                               numel (value{k}))];
  end
  sizes = cellfun (@numel, value(:)');
end

function yes = isPart (v)
  yes = checkIs ('vector', v) || isequal (v, []);
end

function fields = numbered (prefix, n)
  fields = arrayfun (@(i) sprintf ('%s(%d)', prefix, i), 1:n, ...
                     'UniformOutput', false);
end

%!test
%! [v, f, n] = checkElements ({[1, 2], 3}, 'a');
%! assert (v, [1, 2, 3]);
%! assert (f, {'a{1}(1)', 'a{1}(2)', 'a{2}(1)'});
%! assert (n, [2, 1]);
%!test
%! [v, f, n] = checkElements ([1; 2], 'a');
%! assert ({v, f, n}, {[1, 2], {'a(1)', 'a(2)'}, 2});
%!test
%! [v, f, n] = checkElements ({'x'}, 'a');
%! assert (isempty (v) && isempty (f) && isempty (n));
