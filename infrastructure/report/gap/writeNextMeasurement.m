% WRITENEXTMEASUREMENT  Writes the advised test ready to be filled in.
%
% CALL: FILE = writeNextMeasurement (TESTS, CASE, OPTIONS)
%
%   TESTS  of adviseMeasurements
%   CASE   see newCase;  OPTIONS  see gapOptions
%   FILE   path of the table, '' where no test of another bench is advised
%
% Writes gap/next/NAME.csv: rows of measured.csv without values, for the model
% in gap/next/DEMmodels/NAME (caseMeasurements) or of the toolbox. With values in it
% the test belongs to the case from the next start on (filledMeasurements). What was
% tried and is not advised is removed; tables with values stay.

function file = writeNextMeasurement (tests, Case, options)
  file = '';
  place = fullfile (Case.folder, 'gap', 'next');
  best = tests(1:min (1, numel (tests)));
  isAdvised = ~isempty (best) && ~isempty (best.lines) && ...
              best.gain >= options.adviseAt && best.isFirm;
  kept = filledMeasurements (Case.folder);
  if any (~cellfun (@isempty, {tests.lines}))
    removeOthers (place, [kept, {best(isAdvised).model}]);
  end
  if ~isAdvised
    return
  end
  [~, ~] = mkdir (place);
  file = fullfile (place, [best.model, '.csv']);
  head = {['# ', nextText(best)], ...
          ['# Fill in the column value, a line for each trial, and sd, ', ...
           'the uncertainty of a reading; what is not measured stays ', ...
           'empty.'], ...
          '# Then start decalioc diagnose again.', ...
          'model,name,series,at,value,sd,unit,tol'};
  writeAtomic (file, [strjoin([head, best.lines(:)'], "\n"), "\n"]);
end

function removeOthers (place, kept)
  confirm_recursive_rmdir (false, 'local');
  for entry = dir (fullfile (place, 'DEMmodels'))'
    if ~any (strcmp (entry.name, [{'.', '..'}, kept]))
      rmdir (fullfile (place, 'DEMmodels', entry.name), 's');
    end
  end
  for entry = dir (fullfile (place, '*.csv'))'
    if ~any (strcmp (entry.name, strcat (kept, '.csv')))
      unlink (fullfile (place, entry.name));
    end
  end
end

%!test
%! Case.folder = tempname ();
%! place = fullfile (Case.folder, 'gap', 'next');
%! for name = {'A_x_2', 'B', 'C'}
%!   mkdir (fullfile (place, 'DEMmodels', name{1}));
%! end
%! writeAtomic (fullfile (place, 'C.csv'), "model,name,value\nC,w,3\n");
%! writeAtomic (fullfile (place, 'B.csv'), "model,name,value\nB,w,\n");
%! test = struct ('test', 'measure A with x of 2', 'gain', 0.9, 'runs', 16, ...
%!                'isFirm', true, 'between', {{'a', 'b'}}, 'model', ...
%!                'A_x_2', 'variable', 'x', 'value', 2, 'trials', 3, ...
%!                'cost', 1, 'lines', ...
%!                {repmat({'A_x_2,w,,,,,kg,0.05'}, 1, 3)});
%! % given up early: not advised, B is what was advised before
%! options = gapOptions ([]);
%! assert (writeNextMeasurement (setfield (test, 'isFirm', false), Case, options), '');
%! assert (! isfile (fullfile (place, 'B.csv')));
%! mkdir (fullfile (place, 'DEMmodels', 'A_x_2'));
%! file = writeNextMeasurement (test, Case, options);
%! [header, cells] = readCsvTable (file);
%! assert (size (cells), [3, 8]);
%! words = '# measure A with x of 2, 3 trials: to decide between a and b ';
%! assert (strncmp (fileread (file), words, numel (words)));
%! assert (isfolder (fullfile (place, 'DEMmodels', 'A_x_2')));
%! assert (isfile (fullfile (place, 'C.csv')));
%! % what is worth advising is for the options to say
%! few = setfield (test, 'gain', 0.1);
%! assert (~isempty (writeNextMeasurement (few, Case, struct ('adviseAt', 0.05))));
%! % filled in, it stays
%! writeAtomic (file, strrep (fileread (file), 'w,,,,', 'w,,,7,'));
%! writeNextMeasurement (setfield (test, 'gain', 0.1), Case, options);
%! assert (filledMeasurements (Case.folder), {'A_x_2', 'C'});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (Case.folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
