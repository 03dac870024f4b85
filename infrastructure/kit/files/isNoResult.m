% ISNORESULT  Words that stand for a result that is not there.
%
% CALL: [YES, ISFAILED] = isNoResult (TEXTS)
%
%   TEXTS  cell of texts: fields of a table
%   YES    logical, of its size: -, --, n/a, n.a., n.d., NA, NaN, None, null,
%          missing, failed, ?, /, and the errors of spreadsheets: #N/A, #DIV/0!
%   ISFAILED  logical: those that say that a number was looked for in vain, as
%          failed, #DIV/0! and 1.#QNAN, not that nobody looked (#N/A)

function [yes, isFailed] = isNoResult (texts)
  words = {'-', '--', 'n/a', 'n.a.', 'n.d.', 'k.a.', 'na', 'nan', 'none', ...
           'null', 'missing', 'failed', '?', '/', char([226, 128, 147]), ...
           char([226, 128, 148]), '1.#qnan', '-1.#ind', '-nan', '-nan(ind)'};
  bad = {'failed', '1.#qnan', '-1.#ind', '-nan', '-nan(ind)'};
  isFailed = reshape (ismember (lower (texts(:)), bad), size (texts));
  % of no columns, too, the size is that of TEXTS
  yes = reshape (ismember (lower (texts(:)), words), size (texts));
  if any ([texts{:}] == '#')
    isError = ~cellfun ('isempty', regexp (texts, '^#[A-Z/0]+[!?]?$', 'once'));
    yes = yes | isError;
    isEmpty = reshape (ismember (texts(:), {'#N/A', '#NV', '#N/D', '#N/V'}), ...
                       size (texts));
    isFailed = isFailed | isError & ~isEmpty;
  end
end

%!assert (isNoResult ({'-', 'N/A', 'None', '', '0', '-1'}), ...
%!        logical ([1, 1, 1, 0, 0, 0]))
%!assert (size (isNoResult (cell (3, 0))), [3, 0])
%!assert (isNoResult ({'#DIV/0!', '#VALUE!', '#NV', '# 1', '-nan', 'n.d.'}), ...
%!        logical ([1, 1, 1, 0, 1, 1]))
%!assert (nthargout (2, @isNoResult, {'#DIV/0!', '#N/A', 'n/a', 'Failed', '1'}), ...
%!        logical ([1, 0, 0, 1, 0]))

% SPDX-License-Identifier: GPL-3.0-only
