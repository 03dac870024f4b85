% FILLEDTESTS  Advised tests of a case that have been measured since.
%
% CALL: NAMES = filledTests (FOLDER)
%
%   FOLDER  case folder (text)
%   NAMES   1 x n cell: models of gap/next whose table gap/next/NAME.csv has a
%           value in one line at least. readInput adds them to the case
%
% The diagnosis writes these tables without values (writeNextTest).

function names = filledTests (folder)
  names = {};
  place = fullfile (folder, 'gap', 'next');
  for file = {dir(fullfile (place, '*.csv')).name}
    [~, name] = fileparts (file{1});
    [header, cells] = readCsvTable (fullfile (place, file{1}));
    given = cells(:, strcmp (header, 'value'));
    if ~all (cellfun (@isempty, given(:)))
      names{end + 1} = name;
    end
  end
end

%!test
%! folder = tempname ();
%! mkdir (fullfile (folder, 'gap', 'next'));
%! assert (filledTests (folder), {});
%! place = fullfile (folder, 'gap', 'next');
%! writeAtomic (fullfile (place, 'A_x_2.csv'), ...
%!              "# remark\nmodel,name,value\nA_x_2,w,\nA_x_2,w,3\n");
%! writeAtomic (fullfile (place, 'B.csv'), "model,name,value\nB,w,\n");
%! assert (filledTests (folder), {'A_x_2'});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
