% WITHACTION  Puts what to do into a verdict.
%
% CALL: V = withAction (V, TODO)
%
%   V     see decideCase: gets todo, action and actionParts
%   TODO  see newAction

function v = withAction (v, todo)
  [v.todo, v.actionParts] = deal (rmfield (todo, 'parts'), todo.parts);
  v.action = [todo.parts.text];
end

%!test
%! v = withAction (struct (), newAction ('start'));
%! assert ({v.todo.code, v.action}, {'start', 'Start decalioc run in the case folder.'});
%! assert ({v.actionParts.text}, {'Start ', 'decalioc run', ' in the case folder.'});

% SPDX-License-Identifier: GPL-3.0-only
