% MEASUREDREMARKS  Remarks of measured.csv: material, rig, date, who.
%
% CALL: [WORDS, WHOLE] = measuredRemarks (FOLDER)
%
%   FOLDER  case folder (text)
%   WORDS   1 x n cell, the lines that begin with #
%   WHOLE   1 x m cell, the same with lines that were wrapped (60 characters or more)
%           joined to the next

function [words, whole] = measuredRemarks (folder)
  file = fullfile (folder, 'measured.csv');
  words = cell (1, 0);
  if isfile (file)
    found = regexp (readText (file), '^#[ \t]*([^\n]*)', 'tokens', 'lineanchors');
    words = [words, found{:}];
  end
  whole = cell (1, 0);
  isWrapped = false;
  for word = words
    if isWrapped
      whole{end} = [whole{end}, ' ', word{1}];
    else
      whole(end + 1) = word;
    end
    isWrapped = numel (word{1}) >= 60;
  end
end

%!test
%! folder = emptyFolder ();
%! assert (measuredRemarks (folder), cell (1, 0));
%! writeAtomic (fullfile (folder, 'measured.csv'), "# A. Miller, 2026\n#wet\nname,value\n");
%! [words, whole] = measuredRemarks (folder);
%! assert ({words, whole}, {{'A. Miller, 2026', 'wet'}, {'A. Miller, 2026', 'wet'}});
%! long = repmat ('heap ', 1, 13);
%! writeAtomic (fullfile (folder, 'measured.csv'), ['# ', long, "told\n# of days.\n# A\n"]);
%! [words, whole] = measuredRemarks (folder);
%! assert ({numel(words), whole}, {3, {[long, 'told of days.'], 'A'}});

% SPDX-License-Identifier: GPL-3.0-only
