% DECALIOC  Calibrates the parameters of DEM models: main script.
%
% CALL: octave-cli DEcalioc.m      in a shell; or at the prompt: DEcalioc
%
% Calibrates the case of the current folder: its loadInput.m and DEMmodels/
% are looked for there first, then beside this script. What was run before is
% found again, so a calibration that was interrupted goes on where it stopped:
% octave-cli DEcalioc.m afresh moves it aside and starts anew.
%
% In a shell the exit status is 0 where all targets are met, 2 where the
% calibration finished without meeting them, 1 where it could not be done.
% At the prompt the result is left in the variable calibration.
%
% See also: loadInput, costFunction, diagnoseGap

1;    % Octave's help would leave the head to a statement such as the next one

if any (fileparts (mfilename ('fullpath')) == pathsep ())
  error ('DEcalioc:startToolbox:badFolder', ...
         ['the folder of the toolbox, %s, must have a path without a ' ...
          'colon, which parts the folders of the path of Octave. Rename ' ...
          'it.'], fileparts (mfilename ('fullpath')));
end
addpath (fullfile (fileparts (mfilename ('fullpath')), 'infrastructure'));
calibration = startMain (@calibrateCase, fileparts (mfilename ('fullpath')));

% SPDX-License-Identifier: GPL-3.0-only
