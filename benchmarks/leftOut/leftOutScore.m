% LEFTOUTSCORE  Scores the study of left-out runs and prints its figures.
%
% CALL: leftOutScore (FILE, CASES)
%
%   FILE   path of the CSV file of figures;  CASES  1 x n struct of leftOutCase
%
% See also: leftOut, scoreDiagnoses

function leftOutScore (file, cases)
  for i = 1:numel (cases)
    cases(i).interval = cases(i).interval(2:3);
    if ~strcmp (cases(i).class, 'single')
      cases(i).interval = [];
    end
  end
  scoreDiagnoses (file, cases, @linesOf);
end

function lines = linesOf (s, cases)
  strong = s.single & s.d >= 4;
  sure = [cases.pTrue] > 20 / 21 & ~s.null;
  lines = {'false alarm without a gap', ~s.noGap, s.null, '<= 0.07'; ...
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
  guards = {cases.guard};
  guards(cellfun (@isempty, guards)) = {'verdict'};
  for guard = unique (guards(sure & ~s.right))
    lines(end + 1, :) = {['  withheld or wrong: ', guard{1}], ...
                         strcmp(guards, guard{1}) & ~s.right, sure, ''};
  end
end

%!function cases = storedCases (file)
%!  rowsOf = tableRows (file);
%!  words = @(text) strsplit (text, ' ')(1:(end * ! isempty (text)));
%!  for i = numel (rowsOf):-1:1
%!    r = rowsOf(i);
%!    cases(i) = struct ('class', r.class, 'cause', {words(r.cause)}, 'd', ...
%!      str2double (r.d), 'verdict', r.verdict, 'effects', ...
%!      {words(r.effects)}, 'top', r.top, 'phi', str2num (r.phi), 'guard', ...
%!      r.guard, 'pTrue', str2double (r.pTrue), 'interval', ...
%!      [0, str2double(r.lo90), str2double(r.hi90)]);
%!  end
%!endfunction
%!test
%! % the cases that are kept give the figures that are kept
%! results = fullfile (startBenchmarks (), 'benchmarks', 'results');
%! cases = [storedCases(fullfile (results, 'leftOut-hiddenEffect.csv')), ...
%!          storedCases(fullfile (results, 'leftOut-drumAndBins.csv'))];
%! file = tempname ();
%! evalc ('leftOutScore (file, cases);');
%! [~, figures] = originOf (file);
%! delete (file);
%! [~, kept] = originOf (fullfile (results, 'leftOut.csv'));
%! assert (figures, kept);
%!test
%! % two runs with a cause, one named, and one without a gap
%! c = struct ('class', {'single', 'single', 'null'}, 'cause', ...
%!             {{'a'}, {'b'}, {}}, 'phi', {0.5, 0.9, []}, 'd', {5, 6, 0}, ...
%!             'verdict', {'named', 'undecided', 'no gap'}, 'effects', ...
%!             {{'a'}, {}, {}}, 'guard', {'', 'range', 'gate'}, 'top', ...
%!             {'a', 'a', 'a'}, 'pTrue', {0.99, 0.99, 0}, 'interval', ...
%!             {[0.5, 0.4, 0.6], [0.5, 0.4, 0.6], NaN(1, 3)});
%! file = tempname ();
%! evalc ('leftOutScore (file, c);');
%! text = fileread (file);
%! delete (file);
%! has = @(line) ! isempty (strfind (text, line));
%! assert (has ('right effect on top; d >= 4,1,2,0.5000'));
%! assert (has ('withheld or wrong: range,1,2,0.5000'));
%! assert (has ('precision of names,1,1,1.0000'));
