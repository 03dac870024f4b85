% SAYBENCHES  Describes the test rigs of the toolbox.
%
% CALL: STATUS = sayBenches (ROOT, FOLDER, ARGS)
%
%   ROOT    folder of the toolbox (text);  FOLDER  not used
%   ARGS    cell of names of rigs, commas between or not; none: all rigs
%   STATUS  0
%
% Errors: those of commandOptions and listBenches
%
% See also: listBenches, newBenchCase

function status = sayBenches (root, ~, args)
  [~, words] = commandOptions (args, struct ());
  names = setdiff (strsplit (strjoin (words, ','), ','), {''}, 'stable');
  benches = listBenches (root, names);
  status = 0;
  for bench = benches
    printf ("%-10s %s: %s\n", bench.name, bench.title, bench.sees);
    printf ("%10s results: %s\n", '', resultsOf (bench));
    printf ("%10s picture: %s\n", '', bench.picture);
  end
  printf ("\ndecalioc new --bench NAME,NAME FOLDER makes a case of them.\n");
end

function text = resultsOf (bench)
  words = cell (1, numel (bench.results));
  for k = 1:numel (words)
    one = bench.results(k);
    unit = repmat ([' (', one.unit, ')'], 1, ~strcmp (one.unit, '-'));
    words{k} = [one.name, unit];
  end
  text = strjoin (words, ', ');
end

%!test
%! text = evalc ('sayBenches (fileparts (fileparts (which (''startToolbox''))), '''', {});');
%! assert (~isempty (strfind (text, 'massOnPlate (kg)')));
%! assert (~isempty (regexp (text, '^Heap +heap by a lifted tube: static', ...
%!                           'once', 'lineanchors')));
%! root = fileparts (fileparts (which ('startToolbox')));
%! text = evalc ('sayBenches (root, '''', {''Heap,Drum''});');
%! assert (numel (strfind (text, 'picture:')), 2);
%! fail ('sayBenches (root, '''', {''Heep''})', 'got ''Heep''. Did you mean Heap');

% SPDX-License-Identifier: GPL-3.0-only
