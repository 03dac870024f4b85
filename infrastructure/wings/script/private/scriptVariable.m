% SCRIPTVARIABLE  What a variable of a LIGGGHTS script may be from here on.
%
% CALL: [VALUES, NUMBERS] = scriptVariable (WORDS, ISSURE, GIVEN, VALUES, NUMBERS)
%
%   WORDS    1 x n cell: variable NAME STYLE VALUE..., see scriptCommands
%   ISSURE   logical, false: only an if carries it out
%   GIVEN    scalar struct of numbers that -var hands over
%   VALUES   scalar struct, one field a variable: 1 x n cell of the texts that it
%            may have
%   NUMBERS  scalar struct: single numbers of style index; the first one of a
%            name counts, as in LIGGGHTS
%
% See also: scriptFiles, expandWord

function [values, numbers] = scriptVariable (words, isSure, given, values, ...
                                             numbers)
  [name, style] = words{2:3};
  rest = cellfun (@(w) expandWord (w, values), words(4:end), ...
                  'UniformOutput', false);
  rest = [rest{:}];
  isThere = isfield (values, name);
  before = cell (1, 0);
  if isThere && ~isSure
    before = values.(name);
  end
  isList = any (strcmp (style, {'index', 'loop', 'world', 'universe', 'uloop'}));
  if isList && isThere
    return
  end
  if strcmp (style, 'index')
    numbers = withNumber (numbers, name, rest);
  end
  values.(name) = unique ([before, valuesOf(style, rest)]);
  if isList && isfield (given, name)
    values.(name) = {exactNumber(given.(name))};
  elseif isempty (values.(name))
    values = rmfield (values, name);
  end
end

function texts = valuesOf (style, words)
  switch style
    case {'index', 'world', 'universe', 'string'}
      texts = words;
    case {'loop', 'uloop'}
      texts = loopTexts (words);
    case 'getenv'
      texts = {getenv(words{1})};
    case 'equal'
      texts = words(isfinite (str2double (words)));
    otherwise
      texts = cell (1, 0);
  end
end

function numbers = withNumber (numbers, name, words)
  value = str2double (words{1});
  % to str2double 1,5 is 15, and the word i a complex number
  if isscalar (words) && isfinite (value) && isreal (value) && ...
     ~any (words{1} == ',')
    numbers.(name) = value;
  end
end

% loop N [pad], loop N1 N2 [pad]
function texts = loopTexts (words)
  isPadded = strcmp (words{end}, 'pad');
  ends = str2double (words(1:end - isPadded));
  texts = {};
  if all (ends == fix (ends)) && numel (ends) <= 2
    starts = [1, ends(1)];
    first = starts(numel (ends));
    last = min (ends(end), first + 1000);
    width = isPadded * numel (sprintf ('%d', ends(end)));
    texts = arrayfun (@(k) sprintf ('%0*d', width, k), first:last, ...
                      'UniformOutput', false);
  end
end

%!function varargout = after (lines, given)
%!  [values, numbers] = deal (struct ());
%!  for line = lines
%!    words = strsplit (line{1}, ' ');
%!    [values, numbers] = scriptVariable (words(2:end), words{1} == '+', given, ...
%!                                        values, numbers);
%!  end
%!  varargout = {values, numbers};
%!endfunction
%!test
%! lines = {'+ variable a index 2', '+ variable a index 3', ...
%!          '+ variable l index 5 10', '+ variable n loop 2 3', ...
%!          '+ variable p loop 10 pad', '+ variable s string x', ...
%!          '? variable s string y', '+ variable t string z${a}', ...
%!          '+ variable f equal 2*${a}', '+ variable c index 1,5', ...
%!          '+ variable g index 1'};
%! lines = regexprep (lines, '^(\S) variable', '$1 variable');
%! [values, numbers] = after (lines, struct ('g', 7));
%! assert (values.a, {'2'});
%! assert (values.l, {'10', '5'});
%! assert (values.n, {'2', '3'});
%! assert (values.p{1}, '01');
%! assert ({values.s, values.t}, {{'x', 'y'}, {'z2'}});
%! assert (~isfield (values, 'f'));
%! assert (values.g, {'7'});
%! assert (numbers, struct ('a', 2, 'g', 1));

% SPDX-License-Identifier: GPL-3.0-only
