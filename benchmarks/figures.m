% FIGURES  Writes every table of the manual from the results of the programs.
%
% CALL: octave-cli benchmarks/figures.m           (or: make figures)
%       octave-cli benchmarks/figures.m check     (make lint): exit status 1 where a
%             page would change, or results and tables do not belong together; says
%             which results are older than the code that they depend on
%
%       octave-cli benchmarks/figures.m show NAME CSV     prints the table NAME of
%             a CSV that is not published yet
%
% Nothing is run again. A new figure: the program writes benchmarks/results/NAME.csv
% (startTable or writeTable), a row of benchmarks/figures/figures.csv names the
% table that uses it and the rooms that it depends on, a function *Tables.m makes
% text of it, two marks say where it stands (writeFigures).
%
% See also: writeFigures, ageOfResults

here = fileparts (mfilename ('fullpath'));
root = fileparts (here);
% neither packages nor LIGGGHTS are needed
addpath (genpath (fullfile (root, 'infrastructure')), here, fullfile (here, 'figures'));
words = [argv()', {''}];
if strcmp (words{1}, 'show')
  printf ('%s', figureTables ().(words{2}) (@(csv) tableRows (words{3})));
  return
end
isCheck = strcmp (words{1}, 'check');
faults = writeFigures (root, isCheck);
if ~isempty (faults)
  printf ('%s\n', faults{:});
end
old = ageOfResults (root);
if ~isempty (old)
  printf ('WARNING: results are older than code that they depend on:\n');
  printf ('  %s\n', old{:});
end
if ~isempty (faults)
  exit (1);
end

% SPDX-License-Identifier: GPL-3.0-only
