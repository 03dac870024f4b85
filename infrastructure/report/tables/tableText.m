% TABLETEXT  A table as lines of text.
%
% CALL: LINES = tableText (T [, WIDTH])
%
%   T      see newTable
%   WIDTH  characters of a line (79)
%   LINES  1 x n cell: title, head, rows, notes; none for a table without rows
%
% Names stand at the left, numbers end at the right. Heads and the last column,
% where it holds words, go on in further lines.

function lines = tableText (T, width)
  if nargin < 2
    width = 79;
  end
  lines = {};
  if isempty (T) || isempty (T.cells)
    return
  end
  isShown = ~strcmp (T.columns(:, 4), 'page')';
  texts = textsOf (T)(:, isShown);
  isShown(isShown) = [true, ~all(cellfun (@isempty, texts(:, 2:end)), 1)];
  texts = textsOf (T)(:, isShown);
  kinds = T.columns(isShown, 3)';
  heads = withUnits (T.columns(isShown, :));
  size_ = max (cellfun (@numel, texts), [], 1);
  words = cellfun (@(h) max (cellfun (@numel, strsplit (h, ' '))), heads);
  size_ = max (size_, words);
  isWords = strcmp (kinds, 'words');
  left = width - 2 - sum (size_(~isWords) + 2);
  size_(isWords) = max (min (size_(isWords), floor (left / max (sum (isWords), 1)) - 2), 24);
  lines = [{T.title}, oneRow(heads, size_, isWords)];
  for i = 1:rows (texts)
    lines = [lines, oneRow(texts(i, :), size_, isWords)];
  end
  for k = 1:numel (T.notes)
    lines = [lines, strcat({'  '}, wrapText (T.notes{k}, width - 2))];
  end
end

% The code name stands where the page has words.
function texts = textsOf (T)
  texts = cell (size (T.cells));
  for k = 1:numel (texts)
    c = T.cells{k};
    [~, j] = ind2sub (size (T.cells), k);
    texts{k} = c.value;
    if ~isempty (c.code)
      texts{k} = c.code;
    elseif isnumeric (c.value)
      texts{k} = plainNumber (c.value, noiseKind (T.columns{j, 3}, c.value, c.sd));
    end
    if isfinite (c.sd)
      texts{k} = sprintf ('%s +- %.2g', texts{k}, c.sd);
    end
    texts{k} = withUnit (texts{k}, c.unit);
  end
end

function heads = withUnits (columns)
  heads = cellfun (@withUnit, columns(:, 1), columns(:, 2), 'UniformOutput', false)';
end

function lines = oneRow (texts, sizes, isWords)
  parts = arrayfun (@(j) wrapText (texts{j}, sizes(j)), 1:numel (texts), ...
                    'UniformOutput', false);
  n = max (cellfun (@numel, parts));
  lines = repmat ({''}, 1, n);
  for j = 1:numel (parts)
    form = sprintf ('  %%%s%ds', repmat ('-', 1, j == 1 || isWords(j)), sizes(j));
    row = [parts{j}, repmat({''}, 1, n - numel (parts{j}))];
    lines = strcat (lines, cellfun (@(t) {sprintf(form, t)}, row));
  end
  lines = regexprep (lines, ' +$', '');
end

%!test
%! T = newTable (struct ('sources', []), 'x', 'Targets', ...
%!               {'target', '', ''; 'measured value', 'N', 'plain'; ...
%!                'far', '', 'plain'; 'remark', '', 'words'}, ...
%!               {'slope', 3.5, 1, ''; struct('value', 'height of it', 'code', 'h', ...
%!                                           'unit', 'm'), ...
%!                struct('value', 12, 'sd', 0.25), NaN, ...
%!                'it cannot be confirmed with so few'}, {'A note.'});
%! lines = tableText (T, 50);
%! assert (lines{1}, 'Targets');
%! assert (lines(4:5), {'  slope          3.5    1', ...
%!                      '  h (m)   12 +- 0.25    -  it cannot be confirmed'});
%! assert (lines{end}, '  A note.');
%! assert (all (cellfun (@numel, lines) <= 50));
%! assert (isempty (tableText ([])));
%! T.cells{1, 2}.value = 0.453;
%! T.cells{1, 2}.sd = 2.1;
%! assert (! isempty (strfind (tableText (T){4}, ' 0.5 +- 2.1')), tableText (T){4});

% SPDX-License-Identifier: GPL-3.0-only
