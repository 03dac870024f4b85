% EXPANDWORD  A word of a LIGGGHTS script with its variables filled in.
%
% CALL: TEXTS = expandWord (WORD, VALUES)
%
%   WORD    as the script has it (text)
%   VALUES  scalar struct, one field a variable: 1 x n cell of texts that it may
%           have
%   TEXTS   1 x m cell: one a combination of values (the first 1,000); ${NAME}
%           and $x stay where the variable is not known
%
% See also: scriptFiles

function texts = expandWord (word, values)
  texts = {word};
  if ~any (word == '$')
    return
  end
  names = regexp (word, '\$\{(\w+)\}|\$(\w)', 'tokens');
  for name = unique ([cell(1, 0), names{:}])
    if ~isfield (values, name{1})
      continue
    end
    forms = {['${', name{1}, '}'], ['$', name{1}]};
    forms = forms(1:1 + (numel (name{1}) == 1));
    longer = cell (1, 0);
    for value = values.(name{1})
      next = texts;
      for form = forms
        next = strrep (next, form{1}, value{1});
      end
      longer = [longer, next];
    end
    texts = longer(1:min (end, 1000));
  end
end

%!assert (expandWord ('a', struct ()), {'a'})
%!assert (expandWord ('${d}/$n.stl', struct ('d', {{'x', 'y'}}, 'n', {{'1'}})), ...
%!        {'x/1.stl', 'y/1.stl'})
%!assert (expandWord ('${no}', struct ('d', {{'x'}})), {'${no}'})

% SPDX-License-Identifier: GPL-3.0-only
