% FILLEDMEASUREMENTS  Advised tests of a case that have been measured since.
%
% CALL: NAMES = filledMeasurements (FOLDER)
%
%   FOLDER  case folder (text)
%   NAMES   1 x n cell: models of gap/next whose table gap/next/NAME.csv has a
%           value in one line at least, or cannot be read, or has no column
%           value (checkCase says so). readInput adds them to the case
%
% The diagnosis writes these tables without values (writeNextMeasurement).

function names = filledMeasurements (folder)
  names = {};
  place = fullfile (folder, 'gap', 'next');
  for file = {dir(fullfile (place, '*.csv')).name}
    [~, name] = fileparts (file{1});
    if isFilled (fullfile (place, file{1}))
      names{end + 1} = name;
    end
  end
end

function yes = isFilled (file)
  yes = true;
  try
    [header, cells] = readCsvTable (file);
    given = cells(:, strcmp (header, 'value'));
    yes = ~any (strcmp (header, 'value')) || ...
          ~all (cellfun (@isempty, given(:)));
  catch
    % as empty as it may be
  end
end

%!test
%! folder = tempname ();
%! mkdir (fullfile (folder, 'gap', 'next'));
%! assert (filledMeasurements (folder), {});
%! place = fullfile (folder, 'gap', 'next');
%! writeAtomic (fullfile (place, 'A_x_2.csv'), ...
%!              "# remark\nmodel,name,value\nA_x_2,w,\nA_x_2,w,3\n");
%! writeAtomic (fullfile (place, 'B.csv'), "model,name,value\nB,w,\n");
%! assert (filledMeasurements (folder), {'A_x_2'});
%! writeAtomic (fullfile (place, 'B.csv'), "model,name,vale\nB,w,3\n");
%! writeAtomic (fullfile (place, 'C.csv'), "model,name,value\nC,w\n");
%! assert (filledMeasurements (folder), {'A_x_2', 'B', 'C'});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
