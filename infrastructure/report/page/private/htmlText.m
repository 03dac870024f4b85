% HTMLTEXT  Text for HTML: its special characters are masked.
%
% CALL: HTML = htmlText (TEXT)
%
%   TEXT  row of char, UTF-8 (other bytes are taken as Latin-1), or a cell of
%         such
%   HTML  the same, safe between tags and in double quotes

function html = htmlText (text)
  if iscell (text)
    html = cellfun (@htmlText, text, 'UniformOutput', false);
    return
  end
  html = text(:)';
  bytes = uint8 (html);
  if any (bytes > 127)
    try
      known = unicode2native (native2unicode (bytes, 'UTF-8'), 'UTF-8');
    catch
      known = [];
    end
    if ~isequal (known(:)', bytes)
      html(bytes > 127) = '?';
    end
  end
  html = regexprep (oneLine (html), {'&', '<', '>', '"'}, ...
                    {'&amp;', '&lt;', '&gt;', '&quot;'});
end

%!assert (htmlText ('a < "b" & c'), 'a &lt; &quot;b&quot; &amp; c')
%!assert (htmlText (char ([195, 188])), char ([195, 188]))
%!assert (htmlText ({["a\nb", char(252)], ''}), {'a b?', ''})

% SPDX-License-Identifier: GPL-3.0-only
