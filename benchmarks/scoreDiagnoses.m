% SCOREDIAGNOSES  Scores the verdicts of a study whose truth is known.
%
% CALL: S = scoreDiagnoses (FILE, CASES, LINESOF)
%
%   FILE     path of the CSV file of figures, '' = none: figure, hits, cases,
%            share, lo95, hi95, target
%   CASES    1 x n struct: class ('null', 'single', 'pair', or another name: the
%            cause is not on the list), cause (cellstr, true effects that the
%            list holds), d (signal to noise), verdict, effects (cellstr, what
%            the verdict names), top (likeliest effect), phi (strength of the
%            first cause), interval (1 x 2, 90 % of that strength; []: none
%            asked); other fields are for LINESOF
%   LINESOF  handle, LINES = linesOf (S, CASES): m x 4 cell, a figure each: its
%            name, which cases are right and which count (1 x n logical both),
%            and the target as text ('': none)
%   S        struct of 1 x n rows: null, single, pair, out, d, named, grouped,
%            said (either), noGap; top (the likeliest effect is a true one),
%            right (names only true effects, or a group with a true one in it),
%            clean (names or groups nothing but true effects), covered (the
%            interval holds the strength)
%
% Prints each figure with its 95 % Clopper-Pearson interval.
%
% See also: binomialInterval, blindLines, leftOutScore, foreignLines

function s = scoreDiagnoses (file, cases, linesOf)
  class = {cases.class};
  verdict = {cases.verdict};
  s = struct ('null', strcmp (class, 'null'), 'd', [cases.d], ...
              'single', strcmp (class, 'single'), ...
              'pair', strcmp (class, 'pair'), ...
              'named', strcmp (verdict, 'named'), ...
              'grouped', strcmp (verdict, 'group'), ...
              'noGap', strcmp (verdict, 'no gap'));
  s.out = ~(s.null | s.single | s.pair);
  s.said = s.named | s.grouped;
  for i = 1:numel (cases)
    c = cases(i);
    isTrue = ismember (c.effects, c.cause);
    s.top(i) = any (strcmp (c.top, c.cause));
    s.right(i) = any (isTrue) && (s.grouped(i) || all (isTrue));
    s.clean(i) = s.right(i) && all (isTrue);
    s.covered(i) = ~isempty (c.interval) && ...
                   c.interval(1) <= c.phi(1) + 1e-9 && ...
                   c.phi(1) <= c.interval(2) + 1e-9;
  end
  if ~isempty (file)
    writeShares (file, linesOf (s, cases));
  end
end

function writeShares (file, lines)
  out = {'figure,hits,cases,share,lo95,hi95,target'};
  for i = 1:rows (lines)
    [name, hits, counted, target] = lines{i, :};
    k = sum (hits & counted);
    n = sum (counted);
    [lo, hi] = binomialInterval (k, n);
    printf ('%-55s %3d / %3d = %5.1f %%  [%5.1f, %5.1f]  %s\n', name, k, n, ...
            100 * k / max (n, 1), 100 * lo, 100 * hi, target);
    out{end + 1} = sprintf ('%s,%d,%d,%.4f,%.4f,%.4f,%s', ...
                            strrep (name, ',', ';'), k, n, k / max (n, 1), ...
                            lo, hi, target);
  end
  writeTable (file, out);
end

%!shared one
%! one = struct ('class', 'single', 'cause', {{'b'}}, 'd', 5, 'verdict', ...
%!               'named', 'effects', {{'b'}}, 'top', 'b', 'phi', 0.4, ...
%!               'interval', [0.3, 0.5]);
%!test
%! s = scoreDiagnoses ('', one);
%! assert ([s.top, s.right, s.clean, s.covered, s.named] == 1);
%! assert (! (s.out || s.noGap || s.grouped));
%!test
%! % the wrong one, by a hair; a group with others is right, not clean; of a
%! % pair half is clean; a name for what is not on the list is never right
%! cases = repmat (one, 1, 4);
%! [cases.effects] = deal ({'c'}, {'b', 'c'}, {'a'}, {'a'});
%! [cases.verdict] = deal ('named', 'group', 'named', 'named');
%! [cases.class] = deal ('single', 'single', 'pair', 'look');
%! [cases.cause] = deal ({'b'}, {'b'}, {'a', 'b'}, {});
%! cases(1).interval = [0.3, 0.39];
%! cases(2).interval = [];
%! s = scoreDiagnoses ('', cases);
%! assert (s.right, [false, true, true, false]);
%! assert (s.clean, [false, false, true, false]);
%! assert (s.top, [true, true, true, false]);
%! assert (s.covered, [false, false, true, true]);
%! assert (s.out, [false, false, false, true]);
%!test
%! % hits count among the cases only; no case is no division by zero
%! file = [tempname(), '.csv'];
%! lines = @(s, cases) {'right, strong', s.right, [1, 0] > 0, '>= 0.9'; ...
%!                      'none', s.top, [0, 0] > 0, ''};
%! evalc ('scoreDiagnoses (file, [one, one], lines);');
%! [~, text] = originOf (file);
%! text = strsplit (strtrim (text), "\n");
%! unlink (file);
%! assert (text{2}, 'right; strong,1,1,1.0000,0.0250,1.0000,>= 0.9');
%! assert (text{3}, 'none,0,0,0.0000,0.0000,1.0000,');
