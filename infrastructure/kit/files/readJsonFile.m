% READJSONFILE  Reads a JSON file of the case folder; [] where it cannot.
%
% CALL: VALUE = readJsonFile (FILE)
%
%   FILE   path (text); a file that is not there, or half of one, is no file
%   VALUE  see jsondecode

function value = readJsonFile (file)
  value = [];
  try
    if isfile (file)
      value = jsondecode (readText (file));
    end
  catch
    % half a file of another program: as if there were none
  end
end

%!assert (readJsonFile ('/no/such/file'), [])
%!test
%! file = tempname ();
%! writeAtomic (file, '{"a": [1, 2');
%! assert (readJsonFile (file), []);
%! writeAtomic (file, '{"a": [1, 2]}');
%! assert (readJsonFile (file).a, [1; 2]);

% SPDX-License-Identifier: GPL-3.0-only
