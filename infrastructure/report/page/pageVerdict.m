% PAGEVERDICT  The verdict of a report as HTML: its first screen.
%
% CALL: [HTML, WORD] = pageVerdict (PAGE)
%
%   PAGE  see pageData
%   HTML  box with the verdict, what it serves for and what not, what to do, and
%         numbers with their units
%   WORD  the verdict in a few words (text)
%
% Nothing is decided here: it shows what decideCase says.

function [html, word] = pageVerdict (page)
  v = page.verdict;
  word = v.word;
  html = ['<div class="verdict ', v.class, '"><p><span class="word">', ...
          htmlText(v.word), '</span>. ', htmlText(v.sentence), '</p>'];
  if ~isempty (v.gap)
    html = [html, '<p>', htmlText(v.gap), '</p>'];
  end
  html = [html, uses('Use it for', v.usableFor), ...
          uses('Not for', v.notFor), '<h2>What to do now</h2><p>', ...
          coded(htmlText (v.action)), "</p></div>\n"];
  facts = arrayfun (@fact, v.numbers, 'UniformOutput', false);
  if ~isempty (facts)
    html = [html, '<div class="lead"><dl class="facts">', facts{:}, ...
            "</dl>\n<div>", picture(page), "</div></div>\n"];
  end
end

% The bench that misses most, in one picture.
function html = picture (page)
  html = '';
  f = [];
  if ~isempty (page.verdict.worst)
    [f, key] = benchFigure (page, page.verdict.worst);
  end
  if ~isempty (f)
    f.title = ['Where it deviates most: ', f.title];
    f.size(1) = 480;
    html = [htmlFigures(f, '', 'one'), key];
  end
end

function html = uses (title, texts)
  html = '';
  if ~isempty (texts)
    items = cellfun (@(t) ['<li>', htmlText(t), '</li>'], texts, ...
                     'UniformOutput', false);
    html = ['<p><strong>', title, '</strong></p><ul>', items{:}, '</ul>'];
  end
end

% Commands, files and fields as code.
function html = coded (html)
  html = regexprep (html, ['(decalioc (run|diagnose|status)|', ...
                           '\<(results|gap|docs)/[\w.]+\w|', ...
                           '\<(Input|optim)\.\w+|\<load\w+\.m|', ...
                           '\<runs\.csv|\<data\.head)'], '<code>$1</code>');
end

function html = fact (number)
  html = ['<div><dt>', htmlText(number.label), '</dt><dd>', ...
          htmlText(number.text), '</dd></div>'];
end

%!test
%! % user text stays text; commands are set as code
%! page = struct ('verdict', decideCase ([], []));
%! page.verdict.notFor = {'a <b>'};
%! [html, word] = pageVerdict (page);
%! assert (word, 'No result yet');
%! assert (! isempty (strfind (html, '<code>decalioc run</code>')));
%! assert (! isempty (strfind (html, 'a &lt;b&gt;')));
