% NEWACTION  What to do next: a code, what it is about, and the sentence.
%
% CALL: TODO = newAction (CODE [, FIELD [, WIDEN [, FILE]]])
%
%   CODE   of action.* in words.txt (text)
%   FIELD  cellstr ({}): what is to be changed, run or modelled
%   WIDEN  cellstr ({}): parameters at their limits, which may be widened
%   FILE   text (''), where the lines for a model are
%   TODO   struct: code, field, widen, file, text (the sentence, `commands, files and
%          fields` in such marks)

function todo = newAction (code, field, widen, file)
  todo = struct ('code', code, 'field', {{}}, 'widen', {{}}, 'file', '', 'text', '');
  if nargin > 1
    todo.field = field;
  end
  if nargin > 3
    todo.file = file;
  end
  todo.text = sentence (['action.', code], todo);
  if nargin > 2 && ~isempty (widen)
    todo.widen = widen;
    todo.text = [todo.text, ' ', sentence('action.widen', todo)];
  end
end

%!test
%! todo = newAction ('raise', {'optim.maxFunEvals'}, {'mu'});
%! assert ({todo.code, todo.field, todo.widen}, ...
%!         {'raise', {'optim.maxFunEvals'}, {'mu'}});
%! assert (! isempty (regexp (strrep (todo.text, '`', ''), ...
%!                           'optim.maxFunEvals .* of mu,')));
