% NAMEDRESULTS  Results of a run in the order in which its model names them.
%
% CALL: RES = namedResults (MEASURE, FOLDER, MODEL)
%
%   MEASURE  function handle: scalar struct = MEASURE (FOLDER), a field per
%            result by its name in results.csv; what a run does not tell, or
%            all of a run that is not sane, may be left out
%   FOLDER   folder of the run (text)
%   MODEL    model folder with results.csv (text)
%   RES      1 x m cell of scalars, or of curves (n x 2) of which measured.csv
%            reads points, in the order of results.csv; NaN where the run does
%            not tell
%
% What a getResults.m may return. Throws DEcalioc:namedResults:noNames where the
% model has no results.csv, and what MEASURE throws: a file that is missing, and a
% slip in MEASURE as well, is the reason of a failed run.
%
% See also: resultInfo, readDump, readResults, takeReadings

function res = namedResults (measure, folder, model)
  info = resultInfo (model);
  if isempty (info)
    error ('DEcalioc:namedResults:noNames', ...
           ['namedResults: %s must name the results of the model, got no ' ...
            'such file. Write one (name,kind,unit,series,at,text), or ' ...
            'return a row of numbers from getResults.'], ...
           fullfile (model, 'results.csv'));
  end
  names = {info.name};
  res = num2cell (NaN (1, numel (names)));
  found = measure (folder);
  for k = find (isfield (found, names))
    res{k} = found.(names{k});
  end
end

%!test
%! folder = emptyFolder ();
%! writeAtomic (fullfile (folder, 'results.csv'), ...
%!   "name,kind,unit,series,at,text\nmass,mass,kg,,,m\nslope,angle,deg,,,s\n");
%! part = namedResults (@(f) struct ('slope', 30, 'more', 1), '', folder);
%! curve = namedResults (@(f) struct ('mass', [0, 1; 2, 3]), '', folder);
%! assert (part, {NaN, 30});
%! assert (curve, {[0, 1; 2, 3], NaN});
%! % a slip of the user is heard
%! fail ('namedResults (@(f) nothingOfThisName (f), '''', folder)', ...
%!       'nothingOfThisName');
%!error <results.csv must name the results>
%! namedResults (@(f) struct ('a', 1), '', tempname ())

% SPDX-License-Identifier: GPL-3.0-only
