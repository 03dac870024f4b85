% INPUTGATES  What in the input of a run no powder does, and which slip makes it.
%
% CALL: NOTES = inputGates (FOLDER, VALUES)
%
%   FOLDER  of the model (text)
%   VALUES  scalar struct: variables of data.head by their names, and what else a
%           condition of the model may name (results)
%   NOTES   1 x n cell of sentences
%
% A grain has a density of 50 to 23000 kg/m3, a radius up to 0.5 m, a modulus from 1e4
% Pa; and what sample/gates.csv of the model says: columns condition (see readRule) and
% says. A condition of a name that VALUES lacks is left out.
%
% See also: trialGates

function notes = inputGates (folder, values)
  notes = [ofGrains(values), ofModel(folder, values)];
end

function notes = ofGrains (values)
  notes = cell (1, 0);
  for row = {'densityP', 50, 23000, 'kg/m3'; 'radiusP', 0, 0.5, 'm'; ...
             'youngsModulusP', 1e4, Inf, 'Pa'}'
    value = givenField (values, row{1}, NaN);
    if value < row{2} || value > row{3}
      notes{end + 1} = sprintf ('%s is %g, which no grain has: is it in %s?', row{1}, value, ...
                                row{4});
    end
  end
end

function notes = ofModel (folder, values)
  notes = cell (1, 0);
  file = fullfile (folder, 'sample', 'gates.csv');
  if ~isfile (file)
    return
  end
  [header, cells] = readCsvTable (file);
  for row = cells'
    [rule, fault] = readRule (row{strcmp(header, 'condition')}, {}, values);
    if isempty (fault) && ~rule (zeros (1, 0))
      notes{end + 1} = row{strcmp(header, 'says')};
    end
  end
end

%!test
%! % a slip of the unit of a grain; a condition of the model
%! [folder, put] = emptyFolder ();
%! notes = inputGates (folder, struct ('densityP', 1.15, 'radiusP', 2));
%! assert (numel (notes), 2);
%! assert (notes{1}, 'densityP is 1.15, which no grain has: is it in kg/m3?');
%! assert (! isempty (regexp (notes{2}, '^radiusP is 2, .* in m\?')));
%! mkdir (fullfile (folder, 'sample'));
%! put ('sample/gates.csv', ["condition,says\nplate > 8 * radiusP,wide\n", ...
%!                           "slope < 2,not known yet\n"]);
%! assert (inputGates (folder, struct ('radiusP', 0.002, 'plate', 0.01)), {'wide'});

% SPDX-License-Identifier: GPL-3.0-only
