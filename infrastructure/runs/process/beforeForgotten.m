% BEFOREFORGOTTEN  Status and message of a run before decalioc forget.
%
% CALL: [STATUS, MESSAGE] = beforeForgotten (MESSAGE)
%
%   MESSAGE  of a record with the status 'forgotten': 'was STATUS. MESSAGE'; one
%            that says something else is taken as 'failed': such a run counts as
%            little

function [status, message] = beforeForgotten (message)
  parts = regexp (message, '^was (\w+)\. (.*)$', 'tokens', 'once');
  status = 'failed';
  if numel (parts) == 2
    [status, message] = parts{:};
  elseif ~isempty (parts)
    [status, message] = deal (parts{1}, '');
  end
end

%!test
%! for row = {'was ok. ', 'ok', ''; 'was timeout. too. slow', 'timeout', ...
%!            'too. slow'; 'rubbish', 'failed', 'rubbish'}'
%!   [status, message] = beforeForgotten (row{1});
%!   assert ({status, message}, row(2:3)');
%! end

% SPDX-License-Identifier: GPL-3.0-only
