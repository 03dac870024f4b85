% PROPERTYLINES  The lines of a LIGGGHTS script that give a material its values.
%
% CALL: TEXT = propertyLines (FOLDER, VALUES)
%
%   FOLDER  folder of a model (text)
%   VALUES  scalar struct of numbers, one field a calibrated variable
%   TEXT    the lines 'fix ... property/global ...' of in.* there that name one of
%           these variables, with their values (6 digits); other variables have
%           those of data.head, or stay as they are; '': there is no such line
%
% A line that goes on behind an ampersand is read as one.

function text = propertyLines (folder, values)
  head = fullfile (folder, 'data.head');
  known = values;
  if isfile (head)
    known = mergeFields (headDefaults (head), values);
  end
  scripts = glob (fullfile (folder, 'in.*'))';
  script = cellfun (@readText, scripts, 'UniformOutput', false);
  script = regexprep ([script{:}, ''], '&[ \t]*\n', ' ');
  lines = regexp (script, '^[ \t]*fix[ \t].*property/global.*$', 'match', 'lineanchors', ...
                  'dotexceptnewline');
  isAsked = @(line) any (ismember (namesOf (line), fieldnames (values)));
  lines = lines(cellfun (isAsked, lines));
  for name = fieldnames (known)'
    if ~isnan (known.(name{1}))
      value = sprintf ('%.6g', known.(name{1}));
      lines = regexprep (lines, ['\$\{', name{1}, '\}|\<v_', name{1}, '\>'], value);
    end
  end
  lines = regexprep (strtrim (lines), '[ \t]+', ' ');
  text = strjoin ([lines, {''}], "\n");
end

function names = namesOf (line)
  found = regexp (line, '\$\{(\w+)\}|\<v_(\w+)', 'tokens');
  names = [found{:}];
end

%!test
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'data.head'), ...
%!              "variable mu equal 0.1\nvariable e equal 0.5\n");
%! writeAtomic (fullfile (folder, 'in.M'), ...
%!   ["fix m1 all property/global youngsModulus peratomtype 5e6\n", ...
%!    "fix m2 all property/global coefficientFriction peratomtypepair 2 &\n", ...
%!    "  ${mu} ${mu}   ${mu} ${other}\n", ...
%!    "fix m3 all property/global coefficientRestitution peratomtypepair 1 ${e}\n"]);
%! text = propertyLines (folder, struct ('mu', 1 / 3));
%! assert (text, ['fix m2 all property/global coefficientFriction ', ...
%!                "peratomtypepair 2 0.333333 0.333333 0.333333 ${other}\n"]);
%! assert (propertyLines (folder, struct ('a', 1)), '');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
