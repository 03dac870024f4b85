% FAULTCASE  Makes a stand-in case of slow runs, one model under mpirun.
%
% CALL: faultCase (FOLDER)
%
%   FOLDER  folder to be made (text)
%
% The results hold the seed of the run, so a run that was replaced by another
% packing would show.
%
% See also: faultTrial, standInCase

function faultCase (folder)
  standInCase (folder);
  writeLoadInput (folder, 'Input.numOfSam = 8; Input.cpu = [1, 2];');
  first = fullfile (folder, 'DEMmodels', 'First', 'runscript');
  text = strrep (fileread (first), 'e = v["e"]', ...
                 'e = v["e"] + 1e-9 * v["runSeed"]');
  writeAtomic (first, ["sleep 0.2\n", text]);
  second = fullfile (folder, 'DEMmodels', 'Second', 'runscript');
  text = strrep (fileread (second), 'e = v["e"]', ...
                 'e = v["e"] + 1e-9 * v["runSeed"]');
  launch = 'mpirun --oversubscribe -np 2 sleep 0.2';
  writeAtomic (second, [launch, " || exit $?\n", ...
                        text]);
end

% SPDX-License-Identifier: GPL-3.0-only
