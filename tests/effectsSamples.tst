% Each bench evaluates its sample run as it did when the sample was taken, says
% which file of a run is not there, and names its results.

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

%!test % no run: the file that is missing
%! global path
%! path = '/no such folder/';
%! for bench = benches
%!   folder = fullfile (root, 'DEMmodels', bench{1});
%!   addpath (fullfile (folder, 'OctaveFuns'));
%!   fail ('getResults (bench{1}, ''no such run'')', 'output_checks.csv, got');
%!   rmpath (fullfile (folder, 'OctaveFuns'));
%! end
%! clear -global path

% SPDX-License-Identifier: GPL-3.0-only
