% DIAGNOSEGAP  Finds where a calibrated model misses and why: main script.
%
% CALL: octave-cli diagnoseGap.m    in a shell; or at the prompt: diagnoseGap
%
% For the case of the current folder (loadInput.m, loadEffects.m), after or
% without DEcalioc: WHERE the measurements are missed, WHICH unmodelled effect
% causes it, HOW FAR the gap shrinks once it is modelled, and the NEXT TEST.
% Finished runs are taken from the run store and from runs.csv; further ones
% are made within Input.maxNewRuns. Started again, it goes on where it stopped.
%
% Writes gap/gap.json and results/tables/*.csv. In a shell the exit status is 0 with a
% verdict, 2 where the surrogates allow none, 1 where it could not be done.
%
% See also: DEcalioc, loadEffects, diagnoseMatrices

1;    % Octave's help would leave the head to a statement such as the next one

if any (fileparts (mfilename ('fullpath')) == pathsep ())
  error ('DEcalioc:startToolbox:badFolder', ...
         ['the folder of the toolbox, %s, must have a path without a ' ...
          'colon, which parts the folders of the path of Octave. Rename ' ...
          'it.'], fileparts (mfilename ('fullpath')));
end
addpath (fullfile (fileparts (mfilename ('fullpath')), 'infrastructure'));
diagnosis = startMain (@diagnoseCase, fileparts (mfilename ('fullpath')));

% SPDX-License-Identifier: GPL-3.0-only
