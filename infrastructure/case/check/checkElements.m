% CHECKELEMENTS  Lists what a field holds that is given per model and target.
%
% CALL: [VALUES, FIELDS, SIZES] = checkElements (VALUE, PREFIX)
%
%   VALUE   anything; good are a cell of M vectors of real numbers, or of M
%           cells, or one vector of real numbers
%   PREFIX  how the user writes it, e.g. 'optim.tolRes' (text)
%   VALUES  1 x n cell, all elements, model by model
%   FIELDS  1 x n cell, how each is written, e.g. 'optim.tolRes{1}(2)'
%   SIZES   1 x M, elements of each model of the cell; the number of all for
%           one vector; [] where VALUE is of no good kind

function [values, fields, sizes] = checkElements (value, prefix)
  [values, fields] = deal (cell (1, 0));
  sizes = [];
  if checkIs ('vector', value)
    values = num2cell (double (value(:)'));
    fields = numbered ([prefix, '(%d)'], numel (value));
    sizes = numel (value);
  elseif iscell (value) && isvector (value) && ...
         all (cellfun (@isPart, value(:)'))
    for k = 1:numel (value)
      part = value{k}(:)';
      form = sprintf ('%s{%d}(%%d)', prefix, k);
      if iscell (part)
        form = sprintf ('%s{%d}{%%d}', prefix, k);
      else
        part = num2cell (double (part));
      end
      values = [values, part];
      fields = [fields, numbered(form, numel (part))];
    end
    sizes = cellfun (@numel, value(:)');
  end
end

function yes = isPart (v)
  yes = checkIs ('vector', v) || isequal (v, []) || ...
        (iscell (v) && (isvector (v) || isempty (v)));
end

function fields = numbered (form, n)
  fields = arrayfun (@(i) sprintf (form, i), 1:n, 'UniformOutput', false);
end

%!test
%! [v, f, n] = checkElements ({[1, 2], 3, {'x'}}, 'a');
%! assert (v, {1, 2, 3, 'x'});
%! assert (f, {'a{1}(1)', 'a{1}(2)', 'a{2}(1)', 'a{3}{1}'});
%! assert (n, [2, 1, 1]);
%! [v, f, n] = checkElements ([1; 2], 'a');
%! assert ({v, f, n}, {{1, 2}, {'a(1)', 'a(2)'}, 2});
%! assert (isempty (nthargout (3, @checkElements, {'x'}, 'a')));
