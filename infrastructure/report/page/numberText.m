% NUMBERTEXT  A number as the page shows it, as HTML.
%
% CALL: TEXT = numberText (X, KIND)
%
%   X, KIND  see plainNumber ('plain' without KIND)
%   TEXT     a dash where X is not finite

function text = numberText (x, kind)
  if nargin < 2
    kind = 'plain';
  end
  text = strrep (htmlText (plainNumber (x, kind)), ' %', '&thinsp;%');
  text = regexprep (text, 'e\+?(-?)0*(\d+)', '&middot;10<sup>$1$2</sup>');
  text = strrep (regexprep (text, '^-$', '&ndash;'), '-', '&minus;');
end

%!assert (numberText (1234.56), '1235')
%!assert (numberText (-1.234e-7), '&minus;1.234&middot;10<sup>&minus;7</sup>')
%!assert (numberText (0.01234, 'percent'), '1.23&thinsp;%')
%!assert (numberText (0.001, 'probability'), '&lt; 0.01')
%!assert (numberText (1, 'probability'), '1.00')
%!assert (numberText (2.26, 'z'), '+2.3')
%!assert (numberText (NaN), '&ndash;')
%!assert (numberText ([]), '&ndash;')

% SPDX-License-Identifier: GPL-3.0-only
