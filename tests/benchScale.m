% BENCHSCALE  Variables that make a bench small and short, for tests.
%
% CALL: VARIABLES = benchScale (MODEL)
%
% MODEL      text, name of a bench
% VARIABLES  scalar struct to append to its data.head, of its sample/small.head:
%            some ten to a hundred grains, a few tenths of a second; too short
%            for rest, so that only the grains' places count
%
% See also: benchTrial, benchNames

function variables = benchScale (model)
  root = fileparts (fileparts (mfilename ('fullpath')));
  variables = headDefaults (fullfile (root, 'DEMmodels', model, 'sample', ...
                                      'small.head'));
end

%!assert (benchScale ('Heap').heapSolid, 4e-6)
%!error id=DEcalioc:headDefaults:missingFile benchScale ('NoBench')
