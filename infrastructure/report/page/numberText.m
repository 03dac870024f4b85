% NUMBERTEXT  A number as the report shows it, as HTML.
%
% CALL: TEXT = numberText (X, KIND)
%
%   X     scalar real
%   KIND  'plain' (4 significant digits), 'percent' (X is a share: 3 digits),
%         'probability' (two decimals), 'z' (one decimal), 'count',
%         'hours' (X in core seconds)
%   TEXT  a dash where X is not finite

function text = numberText (x, kind)
  if nargin < 2
    kind = 'plain';
  end
  if isempty (x) || ~isfinite (x)
    text = '&ndash;';
    return
  end
  switch kind
    case 'percent'
      text = [short(100 * x, 3), '&thinsp;%'];
    case 'probability'
      text = probability (x);
    case 'z'
      text = sprintf ('%+.1f', x);
    case 'count'
      text = sprintf ('%d', x);
    case 'hours'
      text = short (x / 3600, 3);
    otherwise
      text = short (x, 4);
  end
  text = strrep (text, '-', '&minus;');
end

function text = short (x, digits)
  text = sprintf ('%.*g', digits, x);
  parts = regexp (text, '^(.*)e([+-])0*(\d+)$', 'tokens', 'once');
  if ~isempty (parts)
    sign = strrep (parts{2}, '+', '');
    text = [parts{1}, '&middot;10<sup>', sign, parts{3}, '</sup>'];
  end
end

function text = probability (p)
  if p > 0 && p < 0.005
    text = '&lt; 0.01';
  elseif p < 1 && p > 0.995
    text = '&gt; 0.99';
  else
    text = sprintf ('%.2f', p);
  end
end

%!assert (numberText (1234.56), '1235')
%!assert (numberText (-1.234e-7), '&minus;1.234&middot;10<sup>&minus;7</sup>')
%!assert (numberText (0.01234, 'percent'), '1.23&thinsp;%')
%!assert (numberText (0.001, 'probability'), '&lt; 0.01')
%!assert (numberText (1, 'probability'), '1.00')
%!assert (numberText (2.26, 'z'), '+2.3')
%!assert (numberText (NaN), '&ndash;')
%!assert (numberText ([]), '&ndash;')
