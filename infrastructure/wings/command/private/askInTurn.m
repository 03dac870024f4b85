% ASKINTURN  A row of questions, in which back returns to the one before.
%
% CALL: RESULT = askInTurn (QUESTIONS, ASK)
%
%   QUESTIONS  handle (ASK) -> RESULT, which asks the same again after the same answers
%   ASK        handle (QUESTION, DEFAULT, RULE) -> text, see askPerson

function result = askInTurn (questions, ask)
  said = containers.Map ('KeyType', 'double', 'ValueType', 'any');
  while true
    count = containers.Map ({'k'}, {0});
    try
      result = questions (@(varargin) answer (said, count, ask, varargin{:}));
      return
    catch err
      if ~strcmp (err.identifier, 'DEcalioc:askInTurn:back')
        rethrow (err);
      elseif said.Count > 0
        remove (said, said.Count);
      end
    end
  end
end

% Answers that were given before count again.
function text = answer (said, count, ask, question, default, rule)
  k = count('k') + 1;
  count('k') = k;
  if ~isKey (said, k)
    said(k) = ask (question, default, @(text) unlessBack (text, rule));
  end
  text = said(k);
end

function varargout = unlessBack (text, rule)
  if strcmp (text, 'back')
    error ('DEcalioc:askInTurn:back', 'askInTurn: the question before, please');
  end
  [varargout{1:nargout}] = rule (text);
end

%!function text = typed (list, count, question, default, rule)
%!  count('k') = count('k') + 1;
%!  [text, ~] = rule (list{count('k')});
%!endfunction
%!function all = three (ask)
%!  all = {};
%!  for name = {'a', 'b', 'c'}
%!    all{end + 1} = ask (name{1}, '', @(text) deal (text, ''));
%!  end
%!endfunction
%!test
%! for row = {{'1', '2', '3'}; {'1', '9', 'back', '2', '3'}; {'back', '1', '2', '3'}; ...
%!            {'8', '9', 'back', 'back', '1', '2', 'back', '2', '3'}}'
%!   count = containers.Map ({'k'}, {0});
%!   ask = @(varargin) typed (row{1}, count, varargin{:});
%!   assert (askInTurn (@three, ask), {'1', '2', '3'});
%!   assert (count('k'), numel (row{1}));
%! end
%!error <other> askInTurn (@(ask) error ('DEcalioc:x:y', 'other'), @(varargin) '')

% SPDX-License-Identifier: GPL-3.0-only
