% SCOREDIAGNOSES  Scores the verdicts of a study whose truth is known.
%
% CALL: S = scoreDiagnoses (CASES)
%
%   CASES    1 x n struct: class ('null', 'single', 'pair', or another name: the
%            cause is not on the list), cause (cellstr, true effects that the
%            list holds), d (signal to noise), verdict, effects (cellstr, what
%            the verdict names), top (likeliest effect), phi (strength of the
%            first cause), interval (1 x 2, 90 % of that strength; []: none
%            asked)
%   S        struct of 1 x n rows: null, single, pair, out, d, named, grouped,
%            said (either), noGap; top (the likeliest effect is a true one),
%            right (names only true effects, or a group with a true one in it),
%            clean (names or groups nothing but true effects), covered (the
%            interval holds the strength)
%
% See also: twinsScore

function s = scoreDiagnoses (cases)
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
end

%!shared one
%! one = struct ('class', 'single', 'cause', {{'b'}}, 'd', 5, 'verdict', ...
%!               'named', 'effects', {{'b'}}, 'top', 'b', 'phi', 0.4, ...
%!               'interval', [0.3, 0.5]);
%!test
%! s = scoreDiagnoses (one);
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
%! s = scoreDiagnoses (cases);
%! assert (s.right, [false, true, true, false]);
%! assert (s.clean, [false, false, true, false]);
%! assert (s.top, [true, true, true, false]);
%! assert (s.covered, [false, false, true, true]);
%! assert (s.out, [false, false, false, true]);

% SPDX-License-Identifier: GPL-3.0-only
