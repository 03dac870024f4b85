% BENCHLARGER  Variables that enlarge a bench, and what its results grow by.
%
% CALL: [VARIABLES, GROWTH] = benchLarger (BENCH)
%
% BENCH      text, name of a bench
% VARIABLES  scalar struct to append to its data.head
% GROWTH     1 x m, what each result of the larger system is divided by to
%            compare it (1 unless the table names the result)
%
% Read from DEMmodels/<bench>/sample/larger.csv, whose lines are of the kind
% variable or result, and hold a name and a value.
%
% Errors: DEcalioc:benchLarger:missingFile
%
% See also: benchChecks
function [variables, growth] = benchLarger (bench)
  root = startBenchmarks ();
  folder = fullfile (root, 'DEMmodels', bench);
  file = fullfile (folder, 'sample', 'larger.csv');
  if ~isfile (file)
    error ('DEcalioc:benchLarger:missingFile', ...
           ['benchLarger: the bench must say in %s how it is enlarged, got ' ...
            'no such file.'], file);
  end
  [~, words] = readCsvTable (file);
  values = num2cell (str2double (words(:, 3)));
  isVariable = strcmp (words(:, 1), 'variable');
  variables = cell2struct (values(isVariable), words(isVariable, 2), 1);
  [found, at] = ismember ({resultInfo(folder).name}, words(~isVariable, 2));
  growth = ones (1, numel (found));
  grown = [values{~isVariable}];
  growth(found) = grown(at(found));
end

%!test
%! % 1.5 times the volume of a heap, its lengths scaled alike
%! k = 1.5^(1 / 3);
%! [variables, growth] = benchLarger ('Heap');
%! assert (variables.tubeRadius, 0.015 * k, 1e-16);
%! assert (variables.liftSpeed, 0.12 * sqrt (k), 1e-16);
%! assert (growth, [1, k, 1.5, k], 1e-15);
%!test
%! [variables, growth] = benchLarger ('SlotBin');
%! assert (variables, struct ('binWidth', 0.018, 'glueColumns', 3));
%! assert (growth, [1.5, 1.5, 1, 1.5, 1.5, 1]);
%! assert (benchLarger ('Collapse').columnWidth, 0.08 / 3);
%!test
%! [~, growth] = benchLarger ('Shear');
%! assert (growth, ones (1, 4));
%!error id=DEcalioc:benchLarger:missingFile benchLarger ('NoBench')

% SPDX-License-Identifier: GPL-3.0-only
