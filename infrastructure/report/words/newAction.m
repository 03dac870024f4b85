% NEWACTION  What to do next: a code, what it is about, and what is said of it.
%
% CALL: TODO = newAction (CODE [, FIELD [, WIDEN [, FILE]]])
%
%   CODE   of action.* in words.txt (text)
%   FIELD  cellstr ({}): what is to be changed, run or modelled
%   WIDEN  cellstr ({}): parameters at their limits, which may be widened
%   FILE   text (''), where the lines for a model are
%   TODO   struct: code, field, widen, file, parts (1 x n struct array text, isCode: the
%          sentence, see sentence); sayFirst puts a text before them

function todo = newAction (code, field, widen, file)
  todo = struct ('code', code, 'field', {{}}, 'widen', {{}}, 'file', '');
  if nargin > 1
    todo.field = field;
  end
  if nargin > 3
    todo.file = file;
  end
  [~, parts] = sentence (['action.', code], todo);
  if nargin > 2 && ~isempty (widen)
    todo.widen = widen;
    [~, widening] = sentence ('action.widen', todo);
    parts = [parts, sayFirst(' ', widening)];
  end
  todo.parts = parts;
end

%!test
%! todo = newAction ('raise', {'optim.maxFunEvals'}, {'mu'});
%! assert ({todo.code, todo.field, todo.widen}, ...
%!         {'raise', {'optim.maxFunEvals'}, {'mu'}});
%! assert (! isempty (regexp ([todo.parts.text], 'optim.maxFunEvals .* of mu,')));
%! assert (any (strcmp ({todo.parts([todo.parts.isCode]).text}, 'optim.maxFunEvals')));

% SPDX-License-Identifier: GPL-3.0-only
