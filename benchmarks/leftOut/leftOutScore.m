% LEFTOUTSCORE  Scores the study of left-out runs and prints its figures.
%
% CALL: leftOutScore (FILE, CASES)
%
%   FILE   path of the CSV file of figures;  CASES  1 x n struct of leftOutCase
%
% See also: leftOut, writeShares

function leftOutScore (file, cases)
  s = flags (cases);
  strong = s.single & s.d >= 4;
  sure = [cases.pTrue] > 20 / 21 & ~s.null;
  lines = {'false alarm without a gap', s.alarm, s.null, '<= 0.07'; ...
           'name or group without a gap', s.said, s.null, ''; ...
           'right effect on top, d >= 4', s.top, strong, '>= 0.95'; ...
           'right effect on top, all', s.top, s.single, ''; ...
           'named or grouped rightly, d >= 4', s.right, strong, ''; ...
           'named rightly, d >= 4', s.right & s.named, strong, ''; ...
           'precision of names', s.right, s.named, '>= 0.95'; ...
           'precision of names and groups', s.right, s.said, ''; ...
           '90 % interval of the strength holds it', s.covered, s.single, ...
           '0.85 - 0.95'; ...
           'odds above 20 to 1: named or grouped', s.right, sure, '>= 0.9'; ...
           'pairs: only true effects', s.right, s.pair, ''};
  for guard = unique (s.guard(sure & ~s.right))
    lines(end + 1, :) = {['  withheld or wrong: ', guard{1}], ...
                         strcmp(s.guard, guard{1}) & ~s.right, sure, ''};
  end
  writeShares (file, lines);
end

function s = flags (cases)
  verdict = {cases.verdict};
  s.null = strcmp ({cases.class}, 'null');
  s.single = strcmp ({cases.class}, 'single');
  s.pair = strcmp ({cases.class}, 'pair');
  s.d = [cases.d];
  s.named = strcmp (verdict, 'named');
  s.said = s.named | strcmp (verdict, 'group');
  s.alarm = ~strcmp (verdict, 'no gap');
  s.guard = {cases.guard};
  s.guard(cellfun (@isempty, s.guard)) = {'verdict'};
  for i = 1:numel (cases)
    c = cases(i);
    s.top(i) = any (strcmp (c.top, c.cause));
    hits = ismember (c.effects, c.cause);
    s.right(i) = any (hits) && (~s.named(i) || all (hits));
    s.covered(i) = s.single(i) && c.interval(2) <= c.phi(1) && ...
                   c.phi(1) <= c.interval(3);
  end
end

%!test
%! % two runs with a cause, one named, and one without a gap
%! c = struct ('class', {'single', 'single', 'null'}, 'cause', ...
%!             {{'a'}, {'b'}, {}}, 'phi', {0.5, 0.9, []}, 'd', {5, 6, 0}, ...
%!             'verdict', {'named', 'undecided', 'no gap'}, 'effects', ...
%!             {{'a'}, {}, {}}, 'guard', {'', 'range', 'gate'}, 'top', ...
%!             {'a', 'a', 'a'}, 'pTrue', {0.99, 0.99, 0}, 'interval', ...
%!             {[0.5, 0.4, 0.6], [0.5, 0.4, 0.6], NaN(1, 3)});
%! file = tempname ();
%! leftOutScore (file, c);
%! text = fileread (file);
%! delete (file);
%! assert (~isempty (strfind (text, 'right effect on top; d >= 4,1,2,0.5000')));
%! assert (~isempty (strfind (text, 'withheld or wrong: range,1,2,0.5000')));
%! assert (~isempty (strfind (text, 'precision of names,1,1,1.0000')));
