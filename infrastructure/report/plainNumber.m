% PLAINNUMBER  A number as the report shows it.
%
% CALL: TEXT = plainNumber (X, KIND)
%
%   X     scalar real, or two: an interval
%   KIND  'plain' (4 significant digits; any other word too), 'percent' (X is a
%         share: 3 digits, from ten times on '65 times'), 'p' (two digits, never
%         0, which no count of trials shows), 'probability' (two decimals), 'z' (one decimal),
%         'change' (3 digits), both with their sign, 'count'. 'plain 2', 'change 2':
%         with two digits, see noiseKind; with 0 it is nought
%   TEXT  '-' where X is not finite

function text = plainNumber (x, kind)
  if numel (x) == 2 && all (isfinite (x))
    text = [oneNumber(x(1), kind), ' to ', oneNumber(x(2), kind)];
  elseif isempty (x) || ~isfinite (x(1))
    text = '-';
  else
    text = oneNumber (x(1), kind);
  end
end

function text = oneNumber (x, kind)
  [kind, digits] = strtok (kind);
  forms = struct ('plain', '%.4g', 'percent', '%.3g %%', 'p', '%.2g', ...
                  'probability', '%.2f', 'z', '%+.1f', 'change', '%+.3g', ...
                  'error', '%.2g', 'count', '%d');
  form = givenField (forms, kind, '%.4g');
  if ~isempty (digits)
    form = regexprep (form, '\.\d', ['.', digits(2:end)]);
    x = x * ~strcmp (digits, ' 0');
    form = merge (x == 0, '%d', form);
  end
  text = written (form, x * (1 + 99 * strcmp (kind, 'percent')));
  switch kind
    case 'p'
      if x < 0.001
        text = '< 0.001';
      end
    case 'probability'
      if x >= 0 && x < 0.005
        text = '< 0.01';
      elseif x < 1 && x > 0.995
        text = '> 0.99';
      end
    case 'percent'
      if abs (x) >= 10                   % 6470 % of next to nothing
        text = [written('%.2g', x), ' times'];
      end
  end
end

% 14100, not 1.41e+04
function text = written (form, x)
  text = sprintf (form, x);
  if ~isempty (regexp (text, 'e\+0[345]$', 'once'))
    text = sprintf (merge (text(1) == '+', '%+d', '%d'), str2double (text));
  end
end

%!assert (plainNumber (0.12345, 'percent'), '12.3 %')
%!assert (plainNumber (64.7, 'percent'), '65 times')
%!assert (plainNumber (3901, 'percent'), '3900 times')
%!assert (plainNumber (0, 'p'), '< 0.001')
%!assert (plainNumber (0.0123, 'p'), '0.012')
%!assert (plainNumber (0.001, 'probability'), '< 0.01')
%!assert (plainNumber (0, 'probability'), '< 0.01')
%!assert (plainNumber (1.25, 'z'), '+1.2')
%!assert (plainNumber ([1.5, 2], 'plain'), '1.5 to 2')
%!assert (plainNumber ([NaN, 2], 'plain'), '-')
%!assert (plainNumber ([], 'count'), '-')
%!assert (plainNumber (0.453, 'change 1'), '+0.5')
%!assert (plainNumber (-1.2345, 'plain 3'), '-1.23')
%!assert (plainNumber (14136, 'change 3'), '+14100')
%!assert (plainNumber (-14136, 'error'), '-14000')
%!assert (plainNumber (3e6, 'plain'), '3e+06')
%!assert (plainNumber (-4e-15, 'plain 0'), '0')

% SPDX-License-Identifier: GPL-3.0-only
