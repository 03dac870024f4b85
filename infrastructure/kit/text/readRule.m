% READRULE  Reads a condition on the parameters, such as 'a + 2 * b <= c'.
%
% CALL: [RULE, FAULT] = readRule (TEXT, NAMES, FIXED)
%
%   TEXT   two or more sides of numbers, names, + - * / and brackets, with <,
%          <=, > or >= between them. It is never evaluated as code
%   NAMES  1 x d cell of the names of the parameters
%   FIXED  struct of further names and their values
%   RULE   handle n x d -> n x 1 logical; [] with a fault
%   FAULT  what is wrong with the text, in words; '' where nothing is

function [rule, fault] = readRule (text, names, fixed)
  rule = [];
  [tokens, fault] = tokensOf (text);
  if ~isempty (fault)
    return
  end
  known = struct ('names', {names}, 'fixed', fixed);
  try
    rule = readSides (tokens, known);
  catch err
    if ~strcmp (err.identifier, 'DEcalioc:readRule:badValue')
      rethrow (err);
    end
    fault = err.message;
  end
end

% With an end mark.
function [tokens, fault] = tokensOf (text)
  number = '\d+\.?\d*([eE][-+]?\d+)?|\.\d+([eE][-+]?\d+)?';
  [tokens, rest] = regexp (text, ['[A-Za-z_]\w*|', number, ...
                                  '|<=|>=|[-<>+*/()]'], 'match', 'split');
  rest = strtrim ([rest{:}]);
  fault = '';
  if ~isempty (rest)
    fault = sprintf ('''%s'', which is no part of a condition', rest);
  end
  tokens{end + 1} = 'end';
end

function rule = readSides (tokens, known)
  signs = struct ('op', {'<', '<=', '>', '>='}, ...
                  'f', {@lt, @le, @gt, @ge});
  [left, k] = readSum (tokens, 1, known);
  rule = [];
  while any (strcmp (tokens{k}, {signs.op}))
    compare = signs(strcmp (tokens{k}, {signs.op})).f;
    [right, k] = readSum (tokens, k + 1, known);
    one = @(P) compare (left (P), right (P)) & true (rows (P), 1);
    if isempty (rule)
      rule = one;
    else
      rule = @(P) rule (P) & one (P);
    end
    left = right;
  end
  if isempty (rule) || k < numel (tokens)
    error ('DEcalioc:readRule:badValue', ['''%s'' where <, <=, > or >= ' ...
                                          'should stand'], tokens{k});
  end
end

function [f, k] = readSum (tokens, k, known)
  [f, k] = readProduct (tokens, k, known);
  while any (strcmp (tokens{k}, {'+', '-'}))
    isPlus = tokens{k} == '+';
    [g, k] = readProduct (tokens, k + 1, known);
    if isPlus
      f = @(P) f (P) + g (P);
    else
      f = @(P) f (P) - g (P);
    end
  end
end

function [f, k] = readProduct (tokens, k, known)
  [f, k] = readFactor (tokens, k, known);
  while any (strcmp (tokens{k}, {'*', '/'}))
    isTimes = tokens{k} == '*';
    [g, k] = readFactor (tokens, k + 1, known);
    if isTimes
      f = @(P) f (P) .* g (P);
    else
      f = @(P) f (P) ./ g (P);
    end
  end
end

function [f, k] = readFactor (tokens, k, known)
  token = tokens{k};
  k = k + 1;
  j = find (strcmp (token, known.names), 1);
  value = str2double (token);
  if k > numel (tokens)
    error ('DEcalioc:readRule:badValue', 'an end where a value should stand');
  elseif ~isempty (j)
    f = @(P) P(:, j);
  elseif isfield (known.fixed, token)
    value = known.fixed.(token);
    f = @(P) value;
  elseif any (token(1) == '0':'9') || token(1) == '.'
    f = @(P) value;
  elseif token(1) == '-'
    [g, k] = readFactor (tokens, k, known);
    f = @(P) -g (P);
  elseif token(1) == '('
    [f, k] = readSum (tokens, k, known);
    if ~strcmp (tokens{k}, ')')
      error ('DEcalioc:readRule:badValue', 'a bracket that is not closed');
    end
    k = k + 1;
  else
    error ('DEcalioc:readRule:badValue', ['''%s'', which is neither a ' ...
                                          'parameter nor a variable of ' ...
                                          'modelVars'], token);
  end
end

%!shared names, fixed, P
%! names = {'a', 'b2', 'CoRF_PP'};
%! fixed = struct ('radiusW', 2);
%! P = [1, 2, 3; 3, 2, 1; 2, 2, 2];
%!function is (text, yes)
%!  fixed = struct ('radiusW', 2);
%!  P = [1, 2, 3; 3, 2, 1; 2, 2, 2];
%!  [rule, fault] = readRule (text, {'a', 'b2', 'CoRF_PP'}, fixed);
%!  assert (fault, '');
%!  assert (rule (P), logical (yes(:)));
%!endfunction
%!test is ('a < b2', [1, 0, 0]);
%!test is ('a<=b2<=CoRF_PP', [1, 0, 1]);
%!test is ('a + 2*b2 - CoRF_PP > 4', [0, 1, 0]);
%!test is ('-(a - 3) * 0.5 >= 1e0', [1, 0, 0]);
%!test is ('a - 1 - 1 < 0', [1, 0, 0]);
%!test is ('radiusW / a > 1', [1, 0, 0]);
%!test is ('.5 < 1', [1, 1, 1]);
%!test <*47>
%! for text = {'a', 'a <', 'a < b', 'a == b2', 'a < system ("ls")', ...
%!             '(a < b2', 'a b2 < 1', 'a < 1)', '', 'a < ''x''', 'Inf > a', ...
%!             '2a < 1', 'a ^ 2 < 1', 'a ! < 2'}
%!   [rule, fault] = readRule (text{1}, names, fixed);
%!   assert (isempty (rule));
%!   assert (numel (fault) > 10, 'what: %s', text{1});
%! end

% SPDX-License-Identifier: GPL-3.0-only
