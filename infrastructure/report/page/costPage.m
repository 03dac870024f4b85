% COSTPAGE  Writes the page of a case of one cost: results/report.html.
%
% CALL: FILE = costPage (CASE, B)
%
%   CASE  see newCase;  B  see bestKnown
%   FILE  path of the page (text)

function file = costPage (Case, b)
  [T, texts] = costTable (Case, b);
  texts = strcat ('<p>', htmlText (texts), '</p>');
  [~, base, ending] = fileparts (Case.folder);
  body = ['<div class="verdict open"><p><span class="word">Best set known</span>. ', ...
          htmlText(sprintf ('Smallest %s: %.5g, of %s.', b.name, b.cost, ...
                            countText (b.sets, 'set'))), '</p>', texts{:}, "</div>\n", ...
          tableHtml(T)];
  file = fullfile (Case.folder, 'results', 'report.html');
  writeAtomic (file, plainPage (Case.root, ['Case ', base, ending], ...
                                [strjoin({Case.models.name}, ', '), ', ', b.date], ...
                                body));
end

% SPDX-License-Identifier: GPL-3.0-only
