% MEASUREDREMARKS  Remarks of measured.csv: material, rig, date, who.
%
% CALL: WORDS = measuredRemarks (FOLDER)
%
%   FOLDER  case folder (text)
%   WORDS   1 x n cell, the lines that begin with #

function words = measuredRemarks (folder)
  file = fullfile (folder, 'measured.csv');
  words = cell (1, 0);
  if isfile (file)
    found = regexp (readText (file), '^#[ \t]*([^\n]*)', 'tokens', 'lineanchors');
    words = [words, found{:}];
  end
end

%!test
%! folder = emptyFolder ();
%! assert (measuredRemarks (folder), cell (1, 0));
%! writeAtomic (fullfile (folder, 'measured.csv'), "# A. Miller, 2026\n#wet\nname,value\n");
%! assert (measuredRemarks (folder), {'A. Miller, 2026', 'wet'});
