% WITHACTION  Puts what to do into a verdict.
%
% CALL: V = withAction (V, TODO)
%
%   V     see decideCase: gets todo, action and marked
%   TODO  see newAction

function v = withAction (v, todo)
  [v.todo, v.marked] = deal (rmfield (todo, 'text'), todo.text);
  v.action = strrep (todo.text, '`', '');
end

%!test
%! v = withAction (struct (), newAction ('start'));
%! assert ({v.todo.code, v.action}, {'start', 'Start decalioc run in the case folder.'});
%! assert (v.marked, 'Start `decalioc run` in the case folder.');
