% LISTSENTENCES  A sentence for each list of names that is not empty.
%
% CALL: TEXTS = listSentences (LISTS)
%
%   LISTS  n x 2 cell: code of words.txt, names (cellstr)
%   TEXTS  1 x m cell

function texts = listSentences (lists)
  lists = lists(~cellfun (@isempty, lists(:, 2)), :);
  texts = cellfun (@sentence, lists(:, 1), lists(:, 2), 'UniformOutput', false)';
end

%!assert (listSentences ({'where.odd', {'a'}; 'where.out', {}}), {sentence('where.odd', {'a'})})
%!assert (isempty (listSentences ({'where.odd', {}})))

% SPDX-License-Identifier: GPL-3.0-only
