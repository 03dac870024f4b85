% CHECKELEMENTS  Lists what a field holds that is given per model and target.
%
% CALL: [VALUES, FIELDS, GIVEN] = checkElements (VALUE, FIELD, KIND)
%
%   VALUE   anything
%   FIELD   how the user writes it, e.g. 'optim.tolRes' (text)
%   KIND    what is good: 'cell' (of vectors of numbers, or 'estimate'),
%           'column' (of all numbers, or a cell), 'texts' (a cell of cells)
%   VALUES  1 x n cell, all elements, model by model
%   FIELDS  1 x n cell, how each is written, e.g. 'optim.tolRes{1}(2)'
%   GIVEN   1 x M, elements of each model; of a column one number; [] where
%           VALUE is of another kind: the rest is what is wrong in it, then

function [values, fields, given] = checkElements (value, field, kind)
  [values, fields, given] = deal ({value}, {field}, []);
  isColumn = strcmp (kind, 'column') && isKind ('vector', value);
  if ~isColumn && ~(iscell (value) && isvector (value) && ~isempty (value))
    return
  elseif ~isColumn
    values = value(:)';
    isWord = cellfun (@(v) isequal (v, 'estimate'), values);
    values(strcmp (kind, 'cell') & isWord) = {NaN};
    fields = numbered ([field, '{%d}'], numel (values));
    bad = find (~cellfun (@(v) isPart (v, kind), values), 1);
    if ~isempty (bad)
      [values, fields] = deal (values(bad), fields(bad));
      return
    end
  end
  given = cellfun (@numel, values);
  isText = strcmp (kind, 'texts');
  forms = {'(%d)', '{%d}'};
  for k = 1:numel (values)
    fields{k} = numbered ([fields{k}, forms{1 + isText}], given(k));
    if ~isText
      values{k} = num2cell (double (values{k}(:)'));
    end
    values{k} = values{k}(:)';
  end
  values = [cell(1, 0), values{:}];
  fields = [cell(1, 0), fields{:}];
end

function yes = isPart (v, kind)
  if strcmp (kind, 'texts')
    yes = iscell (v) && (isvector (v) || isempty (v));
  else
    yes = isKind ('vector', v) || (~iscell (v) && isequal (v, []));
  end
end

function names = numbered (form, n)
  names = arrayfun (@(i) sprintf (form, i), 1:n, 'UniformOutput', false);
end

%!test
%! [v, f, n] = checkElements ({[1, 2], 3, []}, 'a', 'column');
%! assert ({v, n}, {{1, 2, 3}, [2, 1, 0]});
%! assert (f, {'a{1}(1)', 'a{1}(2)', 'a{2}(1)'});
%! [v, f, n] = checkElements ([1; 2], 'a', 'column');
%! assert ({v, f, n}, {{1, 2}, {'a(1)', 'a(2)'}, 2});
%! [v, f, n] = checkElements ({{'x', 'y'}}, 'a', 'texts');
%! assert ({v, f, n}, {{'x', 'y'}, {'a{1}{1}', 'a{1}{2}'}, 2});
%! [v, f, n] = checkElements ({1, 'x'}, 'a', 'cell');
%! assert ({v, f, n}, {{'x'}, {'a{2}'}, []});
%! % nothing at all is of another kind; a text of two lines is no word
%! [v, f, n] = checkElements (cell (1, 0), 'a', 'cell');
%! assert ({v, f, n}, {{cell(1, 0)}, {'a'}, []});
%! lastwarn ('');
%! [~, f] = checkElements ({1, ['ab'; 'cd']}, 'a', 'cell');
%! assert ({f, lastwarn()}, {{'a{2}'}, ''});

% SPDX-License-Identifier: GPL-3.0-only
