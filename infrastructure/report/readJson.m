% READJSON  Reads a JSON file of the case folder; [] where it cannot.
%
% CALL: VALUE = readJson (FILE)
%
%   FILE   path (text); a file that is not there, or half of one, is no file
%   VALUE  see jsondecode
%
% See also: jsonAt, pageData

function value = readJson (file)
  value = [];
  try
    if isfile (file)
      value = jsondecode (fileread (file));
    end
  catch
    % half a file of another program: as if there were none
  end
end

%!assert (readJson ('/no/such/file'), [])
%!test
%! file = tempname ();
%! writeAtomic (file, '{"a": [1, 2');
%! assert (readJson (file), []);
%! writeAtomic (file, '{"a": [1, 2]}');
%! assert (readJson (file).a, [1; 2]);
%! unlink (file);
