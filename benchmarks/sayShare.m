% SAYSHARE  Prints a share with its 95 % interval (Clopper-Pearson).
%
% CALL: sayShare (TEXT, IS, AMONG)
%
%   TEXT   what is counted
%   IS     1 x n logical;  AMONG  1 x n logical, those that count
%
% See also: binomialInterval

function sayShare (text, is, among)
  k = sum (is & among);
  n = sum (among);
  [lo, hi] = binomialInterval (k, n);
  printf ('%-42s %3d / %3d = %3.0f %%  (%.0f - %.0f)\n', text, k, n, ...
          100 * k / max (n, 1), 100 * lo, 100 * hi);
end

%!test
%! said = evalc ('sayShare (''named'', [true, true, false], [true, false, true])');
%! assert (regexp (said, '^named +1 /   2 =  50 %  \(1 - 99\)'), 1);
