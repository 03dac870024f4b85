% MEASUREDREMARKS  Remarks of measured.csv: material, rig, date, who.
%
% CALL: WORDS = measuredRemarks (FOLDER)
%
%   FOLDER  case folder (text)
%   WORDS   1 x n cell, the lines that begin with #

function words = measuredRemarks (folder)
  file = fullfile (folder, 'measured.csv');
  words = {};
  if isfile (file)
    found = regexp (readText (file), '^#[ \t]*([^\n]*)', 'tokens', 'lineanchors');
    words = [found{:}];
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! assert (measuredRemarks (folder), {});
%! writeAtomic (fullfile (folder, 'measured.csv'), "# A. Miller, 2026\n#wet\nname,value\n");
%! assert (measuredRemarks (folder), {'A. Miller, 2026', 'wet'});
