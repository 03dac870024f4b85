% Each bench evaluates its sample run as it did when the sample was taken, gives
% NaN for a run that is not there, and names its results.

%!shared root, benches
%! root = fileparts (fileparts (which ('benchTrial')));
%! benches = benchNames ();

%!test % the sample
%! for bench = benches
%!   folder = fullfile (root, 'DEMmodels', bench{1});
%!   addpath (fullfile (folder, 'OctaveFuns'));
%!   results = namedResults (@measureBench, fullfile (folder, 'sample'), ...
%!                           folder);
%!   rmpath (fullfile (folder, 'OctaveFuns'));
%!   text = fileread (fullfile (folder, 'sample', 'expected.csv'));
%!   words = regexp (text, '(\w+),(\S+)', 'tokens');
%!   expected = cellfun (@(w) str2double (w{2}), words);
%!   assert ([results{:}], expected, -1e-6);
%!   names = cellfun (@(w) w{1}, words, 'UniformOutput', false);
%!   assert ({resultInfo(folder).name}, names);
%! end

%!test % no run: as many NaN as results.csv has lines
%! global path
%! path = '/no such folder/';
%! for bench = benches
%!   folder = fullfile (root, 'DEMmodels', bench{1});
%!   addpath (fullfile (folder, 'OctaveFuns'));
%!   results = getResults (bench{1}, 'no such run');
%!   rmpath (fullfile (folder, 'OctaveFuns'));
%!   assert (numel (results), numel (resultInfo (folder)));
%!   assert (isnan ([results{:}]));
%! end
%! clear -global path
