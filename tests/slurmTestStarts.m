% SLURMTESTSTARTS  How often runs of a test case were started.
%
% CALL: N = slurmTestStarts (FOLDER)
%
%   FOLDER  see slurmTestCase
%
% See also: slurmTestCase

function n = slurmTestStarts (folder)
  n = 0;
  file = fullfile (folder, 'optim', 'First', 'starts');
  if isfile (file)
    n = sum (fileread (file) == "\n");
  end
end

% SPDX-License-Identifier: GPL-3.0-only
