% GETOPTIMFOLDER  Names of the run folders that hold a parameter set.
%
% CALL: NAMES = getOptimFolder (PARAMS, CASE)
%
%   PARAMS  1 x d or d x 1 parameter set
%   CASE    see newCase (default: the case of the current folder)
%   NAMES   1 x M cell, the first finished run of each model with exactly these
%           parameters; NaN where there is none
%
% See also: evaluateDEM

function names = getOptimFolder (params, Case)
  if nargin < 2
    Case = loadCase ();
  end
  names = cell (1, numel (Case.models));
  for k = 1:numel (Case.models)
    names{k} = NaN;
    place = runPlace (Case, Case.models(k).name);
    for name = listRunFolders (place)'
      record = readRun (fullfile (place, name{1}));
      if strcmp (givenField (record, 'status', ''), 'ok') && ...
         isequal (toDigits (record.params), toDigits (params(:)')) && ...
         atLastLevel (record.effects, Case)
        names{k} = name{1};
        break
      end
    end
  end
end

%!test
%! Case = readyCase ();
%! runScript ([1, 2, 0, 1], 'First', Case);
%! runScript ([1, 3, 0, 1], 'First', Case);
%! names = getOptimFolder ([1; 3], Case);
%! assert (names{1}, '0002');
%! assert (isnan (names{2}));
%! % a run keeps 15 digits of a set
%! runScript ([1/3, 3, 0, 1], 'First', Case);
%! assert (getOptimFolder ([1/3; 3], Case){1}, '0003');

% SPDX-License-Identifier: GPL-3.0-only
