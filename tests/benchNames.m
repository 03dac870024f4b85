% BENCHNAMES  Names of the benches: models that have a small variant for tests.
%
% CALL: NAMES = benchNames ()
%
% NAMES  1 x b cell, the folders of DEMmodels/ that hold sample/small.head
%
% See also: benchTrial

function names = benchNames ()
  root = fileparts (fileparts (mfilename ('fullpath')));
  files = glob (fullfile (root, 'DEMmodels', '*', 'sample', 'small.head'));
  folders = cellfun (@(f) fileparts (fileparts (f)), files, ...
                     'UniformOutput', false);
  [~, names] = cellfun (@fileparts, folders(:)', 'UniformOutput', false);
end

%!assert (numel (benchNames ()) >= 5)

% SPDX-License-Identifier: GPL-3.0-only
