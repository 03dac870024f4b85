% WRITESHARES  Prints and writes the figures of merit of a study, one a line.
%
% CALL: writeShares (FILE, LINES)
%
%   FILE   path of the CSV file: figure, hits, cases, share, lo95, hi95, target
%   LINES  m x 4 cell, a figure each: its name, which cases are right and which
%          count (1 x n logical both), and the target as text ('': none)
%
% With 95 % Clopper-Pearson intervals.
%
% See also: binomialInterval, blindLines, leftOutScore, twinsScore

function writeShares (file, lines)
  out = {'figure,hits,cases,share,lo95,hi95,target'};
  for i = 1:rows (lines)
    [name, hits, cases, target] = lines{i, :};
    k = sum (hits & cases);
    n = sum (cases);
    [lo, hi] = binomialInterval (k, n);
    printf ('%-55s %3d / %3d = %5.1f %%  [%5.1f, %5.1f]  %s\n', name, k, n, ...
            100 * k / max (n, 1), 100 * lo, 100 * hi, target);
    out{end + 1} = sprintf ('%s,%d,%d,%.4f,%.4f,%.4f,%s', ...
                            strrep (name, ',', ';'), k, n, k / max (n, 1), ...
                            lo, hi, target);
  end
  writeAtomic (file, [strjoin(out, "\n"), "\n"]);
end

%!test
%! % hits count among the cases only; no case is no division by zero
%! file = [tempname(), '.csv'];
%! evalc (['writeShares (file, {''right, strong'', [1, 1, 0] > 0, ', ...
%!         '[0, 1, 1] > 0, ''>= 0.9''; ''none'', true, false, ''''})']);
%! text = strsplit (strtrim (fileread (file)), "\n");
%! unlink (file);
%! assert (text{2}, 'right; strong,1,2,0.5000,0.0126,0.9874,>= 0.9');
%! assert (text{3}, 'none,0,0,0.0000,0.0000,1.0000,');
