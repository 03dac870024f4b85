% FORMSCORE  Prints the figures of the form-error study, from its table.
%
% CALL: formScore (FILE)
%
%   FILE  CSV of formStudy
%
% Shares with 95 % Clopper-Pearson intervals, for each tangent; and how often
% the likeliest effect is a true one where its stated probability lies in a bin
% (reliability; cases with an alarm, listed causes).
%
% See also: formStudy

function formScore (file)
  c = tableRows (file);
  num = @(name) cellfun (@str2double, {c.(name)});
  is = @(name, word) strcmp ({c.(name)}, word);
  [d, tangent, pTop, p] = deal (num ('d'), num ('tangent'), num ('pTop'), ...
                                num ('p'));
  [named, grouped] = deal (is ('verdict', 'named'), is ('verdict', 'group'));
  [alone, pair, without] = deal (is ('class', 'single'), ...
                                 is ('class', 'pair'), is ('class', 'null'));
  listed = alone | pair;
  n = numel (c);
  [right, holds, top, few] = deal (false (1, n));
  for i = 1:n
    cause = strsplit (c(i).cause, ' ');
    said = strsplit (c(i).effects, ' ');
    right(i) = ~isempty (c(i).effects) && all (ismember (said, cause));
    class_ = strsplit (c(i).class90, ' ');
    holds(i) = any (ismember (cause, class_));
    few(i) = numel (class_) <= 3;
    top(i) = any (strcmp (c(i).top, cause));
  end
  sayShare ('alarm without a gap', ~is ('verdict', 'no gap'), without);
  sayShare ('name without a gap', named, without);
  sayShare ('name, cause off the list', named, is ('class', 'unlisted'));
  for t = unique (tangent)
    at = tangent == t;
    printf ('tangent %g\n', t);
    sayShare ('  names that are right', right, named & listed & at);
    sayShare ('  names and classes that hold the cause', holds, ...
              (named | grouped) & listed & at);
    sayShare ('  d >= 4: named rightly', named & right, alone & d >= 4 & at);
    sayShare ('  d >= 4: named, or in three at most', (named | grouped) & holds & ...
              few, alone & d >= 4 & at);
    sayShare ('  d >= 4: named, or in the class', (named | grouped) & holds, ...
              alone & d >= 4 & at);
    sayShare ('  d >= 4: likeliest', top, alone & d >= 4 & at);
  end
  edges = [0, 0.3, 0.5, 0.7, 0.8, 0.9, 0.97, 1.001];
  for i = 1:numel (edges) - 1
    in = pTop >= edges(i) & pTop < edges(i + 1) & listed & p < 0.05;
    sayShare (sprintf ('stated %.2f to %.2f (mean %.2f)', edges(i:i + 1), ...
                       mean (pTop(in))), top, in);
  end
end
