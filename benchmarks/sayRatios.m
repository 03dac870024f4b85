% SAYRATIOS  Prints what settings cost over the cost of one of them.
%
% CALL: sayRatios (NAMES, SECONDS, REFERENCE)
%
% NAMES      1 x m or m x 1 cell of text
% SECONDS    n x m, one row a packing, one column a setting
% REFERENCE  text, one of NAMES
%
% A table row each: name, mean of SECONDS, ratio to the reference (mean of the
% logarithms) and its 95 % interval by Student's distribution over the packings.
%
% See also: liggghtsBuilds, mweWaits

function sayRatios (names, seconds, reference)
  ratio = log (seconds ./ seconds(:, strcmp (names, reference)));
  n = rows (seconds);
  half = studentQuantile (0.975, n - 1) * std (ratio, 0, 1) / sqrt (n);
  for p = 1:numel (names)
    printf ('| %s | %.1f s | %.3f (%.3f to %.3f) |\n', names{p}, ...
            mean (seconds(:, p)), ...
            exp (mean (ratio(:, p)) + [0, -half(p), half(p)]));
  end
end

%!test
%! text = evalc ('sayRatios ({''a'', ''b''}, [1, 2; 2, 4; 4, 8], ''a'')');
%! assert (text, sprintf (['| a | 2.3 s | 1.000 (1.000 to 1.000) |\n', ...
%!                         '| b | 4.7 s | 2.000 (2.000 to 2.000) |\n']));
