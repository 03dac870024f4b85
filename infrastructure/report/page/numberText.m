% NUMBERTEXT  A number as the report shows it, as HTML.
%
% CALL: TEXT = numberText (X, KIND)
%
%   X     scalar real
%   KIND  'plain' (4 significant digits, default), 'percent' (X is a share: 3
%         digits), 'probability' (two decimals), 'z' (one decimal), 'change'
%         (3 digits), both with their sign, 'count'
%   TEXT  a dash where X is not finite

function text = numberText (x, kind)
  if nargin < 2
    kind = 'plain';
  end
  if isempty (x) || ~isfinite (x)
    text = '&ndash;';
    return
  end
  forms = struct ('plain', '%.4g', 'percent', '%.3g', 'probability', '%.2f', ...
                  'z', '%+.1f', 'change', '%+.3g', 'count', '%d');
  if strcmp (kind, 'percent')
    text = [sprintf(forms.(kind), 100 * x), '&thinsp;%'];
  elseif strcmp (kind, 'probability') && x > 0 && x < 0.005
    text = '&lt; 0.01';
  elseif strcmp (kind, 'probability') && x < 1 && x > 0.995
    text = '&gt; 0.99';
  else
    text = sprintf (forms.(kind), x);
  end
  text = regexprep (text, 'e\+?(-?)0*(\d+)', '&middot;10<sup>$1$2</sup>');
  text = strrep (text, '-', '&minus;');
end

%!assert (numberText (1234.56), '1235')
%!assert (numberText (-1.234e-7), '&minus;1.234&middot;10<sup>&minus;7</sup>')
%!assert (numberText (0.01234, 'percent'), '1.23&thinsp;%')
%!assert (numberText (0.001, 'probability'), '&lt; 0.01')
%!assert (numberText (1, 'probability'), '1.00')
%!assert (numberText (2.26, 'z'), '+2.3')
%!assert (numberText (NaN), '&ndash;')
%!assert (numberText ([]), '&ndash;')
