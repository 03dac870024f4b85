% HEADLINES  Lines of a data.head that give variables their values.
%
% CALL: TEXT = headLines (V)
%
%   V     scalar struct of numbers, one field a variable
%   TEXT  lines 'variable NAME equal VALUE', 15 significant digits (toDigits)
function text = headLines (v)
  text = '';
  for name = fieldnames (v)'
    text = [text, sprintf('variable %s equal %.15g\n', name{1}, v.(name{1}))];
  end
end

%!assert (headLines (struct ('a', 0.5, 'b', 3)), ...
%!        sprintf ('variable a equal 0.5\nvariable b equal 3\n'))
%!assert (headLines (struct ()), '')

% SPDX-License-Identifier: GPL-3.0-only
