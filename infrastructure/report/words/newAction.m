% NEWACTION  What to do next: a code, what it is about, and the sentence.
%
% CALL: TODO = newAction (CODE [, FIELD [, WIDEN]])
%
%   CODE   of action.* in words.txt (text)
%   FIELD  cellstr ({}): what is to be changed, run or modelled
%   WIDEN  cellstr ({}): parameters at their limits, which may be widened
%   TODO   struct: code, field, widen, text (the sentence)

function todo = newAction (code, field, widen)
  todo = struct ('code', code, 'field', {{}}, 'widen', {{}}, 'text', '');
  if nargin > 1
    todo.field = field;
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
%! assert (! isempty (regexp (todo.text, 'optim.maxFunEvals .* of mu,')));
