% PLAINTABLE  A table as people have it, so that separators alone part its columns.
%
% CALL: TEXT = plainTable (TEXT)
%
%   TEXT  1 x n char, lines ended by LF; what comes back has the same lines.
%         Emptied are remarks (behind #, % or //; the last one before the numbers
%         is the header where it has as many words, as of numpy), titles above
%         the header and the rule of a table in Markdown. Blanks alone between
%         the columns become tabs, those that do not break plain ones

function text = plainTable (text)
  if any (text > 127)
    text = strrep (text, char ([239, 187, 191]), '');     % further byte orders
    for blank = {[194, 160], [226, 128, 175], [226, 128, 137]}
      text = strrep (text, char (blank{1}), ' ');
    end
  end
  text = withoutRemarks (text);
  text = withoutTitles (text);
  text = withoutFrame (text);
  text = byTabs (text);
end

function text = withoutRemarks (text)
  lead = regexp (text, '^([ \t]*((#|%|//)[^\n]*)?\n)*', 'match', 'once');
  rest = text(numel (lead) + 1:end);
  next = regexp (rest, '^[^\n]*', 'match', 'once');
  header = regexp (lead, '[^\n]*\S[^\n]*\n\s*$', 'once');
  if ~isempty (header)
    last = regexprep (lead(header:end), '^\s*(#|%|//)', ' ');
    isHeader = numel (fieldsOf (last)) == numel (fieldsOf (next)) && ...
               hasNumber (next);
    if ~isHeader
      last = last(last == "\n");
    end
    lead = [lead(lead(1:header - 1) == "\n"), last];
  end
  [from, to] = regexp (rest, '(?<=\n)[ \t]*(#[ \t#a-z]|%[ \t%]|//)[^\n]*');
  isIn = mod (cumsum (rest == '"'), 2);
  for k = find (isIn(from) == 0)
    rest(from(k):to(k)) = ' ';
  end
  text = [lead, rest];
end

% Lines of one field above the header, which has several and no number.
function text = withoutTitles (text)
  ends = [find(text == "\n", 20), numel(text)];
  head = text(1:ends(end - (numel (ends) > 20)));
  lines = strsplit (head, "\n", 'CollapseDelimiters', false);
  counts = cellfun (@(line) numel (fieldsOf (line)), lines);
  isParted = ~cellfun (@isempty, regexp (lines, '[,;\t|]', 'once'));
  k = find (isParted & counts > 1, 1);
  titles = find (counts(1:k - 1) > 0);
  isMarked = ~cellfun (@isempty, regexp (lines(titles), '^"?sep=|^[^"]*"[^"]*$', ...
                                         'once'));
  if isempty (titles) || any (isMarked) || hasNumber (lines{k}) || ...
      any (counts(titles) > 1 & isParted(titles))
    return
  end
  lines(titles) = {''};
  text = [strjoin(lines, "\n"), text(numel (head) + 1:end)];
end

% Bars around a table, as in Markdown.
function text = withoutFrame (text)
  if ~isempty (regexp (text, '^\s*\|', 'once'))
    text = regexprep (text, {'^[ \t]*\|[-:| \t]+\|[ \t]*$', '^[ \t]*\|', ...
                             '\|[ \t]*$'}, '', 'lineanchors');
  end
end

% Blanks in quotes and those before a unit in brackets do not part.
function text = byTabs (text)
  quoted = mod (cumsum (text == '"'), 2) == 1;
  first = regexp (text(~quoted), '^\s*[^\n]*', 'match', 'once');
  if any (ismember (first, [',;|', "\t"])) || ...
     isempty (strfind (strtrim (first), ' '))
    return
  end
  whole = text;
  whole(quoted & text == ' ') = "\1";
  lines = strtrim (strsplit (whole, "\n", 'CollapseDelimiters', ...
                             false));
  lines = regexprep (lines, {' +(?=[[(][^])]*[])])', ' +'}, {"\1", "\t"});
  counts = cellfun (@(line) sum (line == "\t"), ...
                    lines(~cellfun (@isempty, lines)));
  hasNames = any (quoted) && numel (counts) > 1 && ...
             all (counts(2:end) == counts(1) + 1);
  if numel (counts) > 1 && (all (counts == counts(1)) || hasNames)
    text = strrep (strjoin (lines, "\n"), "\1", ' ');
  end
end

% Between separators where there are some, else between blanks.
function fields = fieldsOf (line)
  line = regexprep (strtrim (line), '"[^"]*"', 'q');
  pattern = '[^,;\t|]+';
  if isempty (regexp (line, '[,;\t|]', 'once'))
    pattern = '\S+';
  end
  fields = strtrim (regexp (line, pattern, 'match'));
  fields = fields(~cellfun (@isempty, fields));
end

function yes = hasNumber (line)
  fields = strtrim (strrep (fieldsOf (line), '"', ''));
  number = '^[-+]?(\d+[.,]?\d*|[.,]\d+)([eE][-+]?\d+)?$';
  yes = ~all (cellfun ('isempty', regexp (fields, number, 'once')));
end

%!assert (plainTable ("# of: sand\n# by: me\na,b\n1,2\n"), "\n\na,b\n1,2\n")
%!assert (plainTable ("% by me\n% a b\n1 2\n"), "\na\tb\n1\t2\n")
%!assert (plainTable ("#run,a\n1,2\n# two\n3,4\n"), " run,a\n1,2\n     \n3,4\n")
%!assert (plainTable ("Heaps of May;;\n\na;b\n1;2\n"), "\n\na;b\n1;2\n")
%!assert (plainTable ("heap\na,b\n1,2\n"), "\na,b\n1,2\n")
%!assert (plainTable ("| a | b |\n|---|:-:|\n| 1 | 2 |\n"), " a | b \n\n 1 | 2 \n")
%!assert (plainTable ("\"a c\" \"b\"\n\"1\" 2 3\n\"2\" 3 4\n"), ...
%!        "\"a c\"\t\"b\"\n\"1\"\t2\t3\n\"2\"\t3\t4\n")
%!test
%! % left alone: a unit behind %, a column of words, a value #N/A, quotes
%! for text = {"% fines,x\n1,2\n", "a\n1\n2\n", "a,b\n#N/A,1\n", ...
%!             "\"x\ny\",b\n1,2\n", "a,\"b\n# c\"\n1,2\n", "sep=;\na;b\n1;2\n", ...
%!             "a\n0,5\n1,5\n"}
%!   assert (strtrim (strrep (plainTable (text{1}), '  fines', '% fines')), ...
%!           strtrim (text{1}));
%! end

% SPDX-License-Identifier: GPL-3.0-only
