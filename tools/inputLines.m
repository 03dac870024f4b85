% INPUTLINES  The lists of docs/inputs.md: the fields of Input and of optim.
%
% CALL: PAGE = inputLines (PAGE)
%
%   PAGE  text of the page; between <!-- fields of PART --> and the next
%         <!-- end --> stand the lines that are made of inputFields
%
% Called by make index, and by tests/inputsDoc.tst.

function page = inputLines (page)
  fields = inputFields ();
  for part = {'Input', 'optim'}
    mark = sprintf ('<!-- fields of %s -->', part{1});
    lines = arrayfun (@lineOf, fields(strcmp ({fields.part}, part{1})), ...
                      'UniformOutput', false);
    from = strfind (page, mark) + numel (mark);
    to = from - 1 + strfind (page(from:end), '<!-- end -->')(1);
    page = [page(1:from - 1), "\n\n", strjoin(lines, ''), "\n", page(to:end)];
  end
end

function text = lineOf (f)
  holds = f.holds;
  if isempty (holds) && strcmp (f.kind, 'open')
    holds = sprintf ('between %g and %g', f.low, f.high);
  elseif any (strcmp (f.kind, {'integer', 'number'})) && isempty (holds)
    holds = sprintf ('%s from %g', f.kind, f.low);
  end
  parts = {holds};
  if f.needed
    parts{end + 1} = 'needed';
  elseif isempty (strfind (holds, 'default')) && ~isempty (f.default) && ...
         isempty (strfind (holds, 'needed'))
    parts{end + 1} = ['default ', valueText(f.default)];
  end
  parts = parts(~cellfun (@isempty, parts));
  text = sprintf ('* `%s%s` (%s): %s', f.name, f.index, strjoin (parts, '; '), ...
                  f.help);
  if strcmp (f.holds, 'folder')
    text = sprintf ('* `%s`: folder %s', f.name, f.help);
  end
  text = folded (text);
end

function text = valueText (value)
  if ischar (value)
    text = sprintf ('`''%s''`', value);
  elseif islogical (value)
    words = {'false', 'true'};
    text = words{1 + value};
  else
    text = sprintf ('%g', value);
  end
end

% Lines of at most 100 characters, those after the first set in; code stays whole.
function text = folded (words)
  text = '';
  line = '';
  for word = regexp (words, '(`[^`]*`|[^\s`])+', 'match')
    if numel (line) + 1 + numel (word{1}) > 100
      text = [text, line, "\n"];
      line = [' ', ' ', word{1}];
    else
      line = [line, repmat(' ', 1, ~isempty (line)), word{1}];
    end
  end
  text = [text, line, "\n"];
end

% SPDX-License-Identifier: GPL-3.0-only
