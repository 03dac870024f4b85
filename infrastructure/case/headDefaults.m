% HEADDEFAULTS  Values that a data.head declares.
%
% CALL: DEFAULTS = headDefaults (FILE)
%
%   FILE      path of a data.head (text)
%   DEFAULTS  scalar struct, one field a declared variable: its number, or NaN
%             where it is a formula or a text
%
% Read are lines of the form: variable NAME equal|string VALUE  # comment
% A line "include OTHER" stands for the file OTHER beside FILE, if it is there:
% the shared file of the candidate effects declares their neutral values.
%
% Errors: DEcalioc:headDefaults:missingFile

function defaults = headDefaults (file)
  if ~isfile (file)
    error ('DEcalioc:headDefaults:missingFile', ...
           'headDefaults: %s must exist; it declares the variables.', file);
  end
  [folder, base, ending] = fileparts (file);
  defaults = struct ();
  for line = checkHead (folder, [base, ending])
    if isvarname (line.name) && ~isempty (line.style)
      defaults.(line.name) = str2double (line.value);
    end
  end
end

%!test
%! file = tempname ();
%! writeAtomic (file, ["variable a equal 5e6 # ", 252, ...
%!                     "\n# variable no equal 1\n", ...
%!                     "variable b equal 2*${a}\n  variable a equal 7\n"]);
%! d = headDefaults (file);
%! assert (d.a, 7);
%! assert (isnan (d.b));
%! assert (sort (fieldnames (d)), {'a'; 'b'});
%!test
%! file = tempname ();
%! other = [file, '.effects'];
%! [~, base, ending] = fileparts (other);
%! writeAtomic (other, "variable glue equal 3\nvariable a equal 1\n");
%! writeAtomic (file, ["include ", base, ending, "\nvariable a equal 2\n"]);
%! d = headDefaults (file);
%! assert ([d.glue, d.a], [3, 2]);
%!error id=DEcalioc:headDefaults:missingFile headDefaults ('/nowhere')

% SPDX-License-Identifier: GPL-3.0-only
