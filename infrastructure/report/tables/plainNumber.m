% PLAINNUMBER  A number as the report shows it.
%
% CALL: TEXT = plainNumber (X, KIND)
%
%   X     scalar real, or two: an interval
%   KIND  'plain' (4 significant digits; any other word too), 'percent' (X is a
%         share: 3 digits), 'probability' (two decimals), 'z' (one decimal),
%         'change' (3 digits), both with their sign, 'count'
%   TEXT  '-' where X is not finite

function text = plainNumber (x, kind)
  if numel (x) == 2 && all (isfinite (x))
    text = [plainNumber(x(1), kind), ' to ', plainNumber(x(2), kind)];
    return
  elseif isempty (x) || ~isfinite (x(1))
    text = '-';
    return
  end
  forms = struct ('plain', '%.4g', 'percent', '%.3g %%', 'probability', '%.2f', ...
                  'z', '%+.1f', 'change', '%+.3g', 'error', '%.2g', 'count', '%d');
  form = givenField (forms, kind, '%.4g');
  x = x(1) * (1 + 99 * strcmp (kind, 'percent'));
  if strcmp (kind, 'probability') && x > 0 && x < 0.005
    text = '< 0.01';
  elseif strcmp (kind, 'probability') && x < 1 && x > 0.995
    text = '> 0.99';
  else
    text = sprintf (form, x);
  end
end

%!assert (plainNumber (0.12345, 'percent'), '12.3 %')
%!assert (plainNumber (0.001, 'probability'), '< 0.01')
%!assert (plainNumber (1.25, 'z'), '+1.2')
%!assert (plainNumber ([1.5, 2], 'plain'), '1.5 to 2')
%!assert (plainNumber ([NaN, 2], 'plain'), '-')
%!assert (plainNumber ([], 'count'), '-')
