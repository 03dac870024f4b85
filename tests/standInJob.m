% STANDINJOB  A job for tests of a function that looks at no model.
%
% CALL: JOB = standInJob (KEY)
%
%   KEY  text (default: 64 times a)
%   JOB  struct, see newJobs: the first packing of a set of one parameter

function job = standInJob (key)
  if nargin < 1
    key = repmat ('a', 1, 64);
  end
  job = struct ('model', 'M', 'stage', 'plan', 'planRow', 1, 'params', 1, ...
                'effects', [], 'replicate', 1, 'seed', 10007, 'key', key, ...
                'input', '', 'variables', '', 'origin', '', 'attempt', 0);
end

% SPDX-License-Identifier: GPL-3.0-only
